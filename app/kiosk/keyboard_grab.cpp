// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/keyboard_grab.h"

#include <X11/Xlib.h>

// As GLFW/glfw3native.h declares it, which wants RandR's headers too.
extern "C" Window glfwGetX11Window(GLFWwindow* window);
extern "C" Display* glfwGetX11Display();

namespace obscura::app::kiosk {

bool grab_keyboard(GLFWwindow* window) {
    Display* const display = glfwGetX11Display();
    if (display == nullptr) return false;
    // GLFW reads the keys from its own connection, to which the grab is.
    const int result = XGrabKeyboard(display, glfwGetX11Window(window), True, GrabModeAsync,
                                     GrabModeAsync, CurrentTime);
    return result == GrabSuccess;
}

}  // namespace obscura::app::kiosk
