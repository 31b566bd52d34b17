// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"
#include "stimuli/scenes/validity.h"

namespace obscura::stimuli {

/// A scene made by code: the same triangles and texels on every machine and in every run.
struct BuiltinScene {
    std::string id;
    std::string title;          ///< one line: what is to be seen
    std::string stands_in_for;  ///< what the thesis showed in its place
    std::vector<Validity> levels;
    std::vector<std::string> cameras;  ///< names that build() gives its cameras
    renderer::Scene (*build)() = nullptr;
    renderer::Lighting (*lighting)(Validity) = nullptr;  ///< for one of `levels`
};

/// All built-in scenes.
[[nodiscard]] const std::vector<BuiltinScene>& builtin_scenes();

/// The scene of that id, or nullptr.
[[nodiscard]] const BuiltinScene* find_builtin_scene(std::string_view id);

}  // namespace obscura::stimuli
