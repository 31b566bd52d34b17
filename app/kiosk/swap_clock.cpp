// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/swap_clock.h"

#include <epoxy/gl.h>
// After epoxy, which brings the OpenGL declarations.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/kiosk/clock.h"

// As GLFW/glfw3native.h declares them, with Xlib's own types left out.
extern "C" void* glfwGetX11Display();
extern "C" unsigned long glfwGetGLXWindow(GLFWwindow* window);

namespace obscura::app::kiosk {

SwapClock::SwapClock(GLFWwindow* window)
    : display_(glfwGetX11Display()), drawable_(glfwGetGLXWindow(window)) {
    if (glfwExtensionSupported("GLX_OML_sync_control") != GLFW_TRUE) return;
    wait_for_swap_ = reinterpret_cast<WaitForSwap>(glfwGetProcAddress("glXWaitForSbcOML"));
}

const char* SwapClock::source() const {
    return wait_for_swap_ != nullptr ? "GLX_OML_sync_control" : "glFinish after the swap";
}

double SwapClock::shown_s() {
    constexpr double kMicrosecondsPerSecond = 1e6;
    constexpr double kLongestSwap_s = 0.5;
    std::int64_t time_us = 0;
    std::int64_t refreshes = 0;
    std::int64_t swaps = 0;
    // Target 0: until all swaps asked for so far are done.
    const bool told = wait_for_swap_ != nullptr &&
                      wait_for_swap_(display_, drawable_, 0, &time_us, &refreshes, &swaps) != 0;
    if (!told) glFinish();
    const double now_s = monotonic_s();
    if (!told) return now_s;
    const double swapped_s = static_cast<double>(time_us) / kMicrosecondsPerSecond;
    // The extension does not say which clock it reads; Mesa's is this one. A time of another, or
    // none, is not taken, now nor later.
    if (swapped_s <= now_s && swapped_s > now_s - kLongestSwap_s) return swapped_s;
    wait_for_swap_ = nullptr;
    glFinish();
    return monotonic_s();
}

}  // namespace obscura::app::kiosk
