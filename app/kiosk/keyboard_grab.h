// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

struct GLFWwindow;

namespace obscura::app::kiosk {

/// Takes the whole keyboard of the X server for that window, so that no key of the window manager
/// or the desktop works (Alt+Tab, Super); it is given back with the window, or when it can no
/// longer be seen. Gives whether it has it: false where another program has grabbed it, where the
/// window is not to be seen yet, and where there is no X server.
[[nodiscard]] bool grab_keyboard(GLFWwindow* window);

}  // namespace obscura::app::kiosk
