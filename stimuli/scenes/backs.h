// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stimuli/scenes/open_scene.h"

namespace obscura::stimuli {

/// From this share of what a camera sees on, backs are worth a note.
inline constexpr double kMuchFromBehind = 0.1;

/// A sentence where much of what the cameras see of a file's scene is turned away from them: of
/// glTF the backs that are not drawn, of OBJ, which knows no sides, all. "" where it is not, and
/// for built-in scenes and where a camera cannot be. Of many cameras the first 32 are asked.
[[nodiscard]] std::string note_on_backs(const OpenedScene& opened,
                                        std::vector<renderer::Camera> cameras);

}  // namespace obscura::stimuli
