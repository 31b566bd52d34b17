// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/cover_watch.h"

#include <X11/Xlib.h>

// As GLFW/glfw3native.h declares it, which wants RandR's headers too.
extern "C" Window glfwGetX11Window(GLFWwindow* window);

namespace obscura::app::kiosk {

CoverWatch::CoverWatch(GLFWwindow* window) {
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) return;
    connection_ = display;
    XSelectInput(display, glfwGetX11Window(window), VisibilityChangeMask);
    XSync(display, False);
}

CoverWatch::~CoverWatch() {
    if (connection_ != nullptr) XCloseDisplay(static_cast<Display*>(connection_));
}

bool CoverWatch::covered() {
    auto* display = static_cast<Display*>(connection_);
    while (display != nullptr && XPending(display) > 0) {
        XEvent event;
        XNextEvent(display, &event);
        if (event.type != VisibilityNotify) continue;
        covered_ = event.xvisibility.state != VisibilityUnobscured;
    }
    return covered_;
}

}  // namespace obscura::app::kiosk
