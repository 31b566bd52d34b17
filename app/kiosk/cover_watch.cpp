// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/cover_watch.h"

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

// As GLFW/glfw3native.h declares it, which wants RandR's headers too.
extern "C" Window glfwGetX11Window(GLFWwindow* window);
extern "C" Display* glfwGetX11Display();

namespace obscura::app::kiosk {

namespace {

constexpr unsigned long kNewLayout = XkbNewKeyboardNotifyMask | XkbMapNotifyMask;

/// Makes GLFW's connection read what the keys type: on its own it misses the first new layout.
void refresh_keys() {
    Display* display = glfwGetX11Display();
    int first = 0;
    int last = 0;
    XDisplayKeycodes(display, &first, &last);
    XEvent event{};
    event.xmapping.type = MappingNotify;
    event.xmapping.display = display;
    event.xmapping.request = MappingKeyboard;
    event.xmapping.first_keycode = first;
    event.xmapping.count = last - first + 1;
    XRefreshKeyboardMapping(&event.xmapping);
}

}  // namespace

CoverWatch::CoverWatch(GLFWwindow* window) {
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) return;
    connection_ = display;
    XSelectInput(display, glfwGetX11Window(window), VisibilityChangeMask);
    XkbSelectEvents(display, XkbUseCoreKbd, kNewLayout, kNewLayout);
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
        if (event.type == VisibilityNotify) {
            covered_ = event.xvisibility.state != VisibilityUnobscured;
        } else {
            refresh_keys();
        }
    }
    return covered_;
}

}  // namespace obscura::app::kiosk
