// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "app/explorer/choices.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app::explorer {

/// The choices with everything that nothing could be rendered of made what is next to it; a side
/// that cannot be mended so is that of `before`.
[[nodiscard]] Choices sane(Choices choices, const Choices& before);

/// At a level that the scene has light for: the same where it has, else its first.
[[nodiscard]] Choices with_light_there_is(Choices choices, const stimuli::OpenedScene& opened);

}  // namespace obscura::app::explorer
