// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "renderer/base/error.h"

namespace obscura::app::window {

/// Begins with GLFW. Throws failure when there is no display, with its reason, what the environment
/// says of a display, and whom that stops (`the kiosk`).
void start_glfw(std::string_view who);

/// Hints for the next window: an OpenGL 4.5 core context, 8 bits a channel, no depth of its own.
void ask_for_context();

/// What to throw where such a window could not be made: the reason and the package that helps.
[[nodiscard]] base::Error no_context();

}  // namespace obscura::app::window
