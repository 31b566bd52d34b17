// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/window.h"

#include <epoxy/gl.h>
// After epoxy, which brings the OpenGL declarations.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/kiosk/clock.h"
#include "renderer/base/error.h"

namespace obscura::app::kiosk {
namespace {

/// What the pages need; a plain window is at least this large.
constexpr Extent kSmallestWindow{1024, 720};

[[nodiscard]] std::string glfw_reason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

[[nodiscard]] std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? fmt::format("{} is {}", name, value)
                            : fmt::format("{} is not set", name);
}

[[nodiscard]] std::string text_of(Extent extent) {
    return fmt::format("{}x{}", extent.width, extent.height);
}

[[nodiscard]] Extent size_of(GLFWmonitor* monitor) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    return mode != nullptr ? Extent{mode->width, mode->height} : Extent{};
}

[[nodiscard]] GLFWmonitor* find_monitor(int index) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    if (count == 0) throw base::failure("no monitor is connected to this display");
    if (index >= 0 && index < count) return monitors[index];
    std::string known;
    for (int i = 0; i < count; ++i) {
        known += fmt::format("{}{} ({} {})", i == 0 ? "" : ", ", i, glfwGetMonitorName(monitors[i]),
                             text_of(size_of(monitors[i])));
    }
    throw base::bad_input("--monitor: {} is not connected, there is {}", index, known);
}

void require_room(Extent place, Extent room, const std::string& what) {
    if (place.width >= room.width && place.height >= room.height) return;
    throw base::bad_input(
        "{} is {}, the images are {}: they are shown at 1:1 pixels and do not fit", what,
        text_of(place), text_of(room));
}

void set_hints() {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RED_BITS, 8);
    glfwWindowHint(GLFW_GREEN_BITS, 8);
    glfwWindowHint(GLFW_BLUE_BITS, 8);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SAMPLES, 0);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    // A participant who reaches another window must not make the stimulus vanish.
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_TRUE);
}

}  // namespace

/// GLFW's callbacks, which get the window through its user pointer.
struct Window::Callbacks {
    [[nodiscard]] static Window& of(GLFWwindow* window) {
        return *static_cast<Window*>(glfwGetWindowUserPointer(window));
    }
    static void key(GLFWwindow* window, int key, int /*scancode*/, int action, int modifiers) {
        Input& input = of(window).input_;
        if (action == GLFW_PRESS) input.key_down({key, modifiers, monotonic_s()});
        if (action == GLFW_REPEAT) input.key_repeats(key, modifiers);
    }
    static void character(GLFWwindow* window, unsigned code) {
        of(window).input_.types(static_cast<char32_t>(code));
    }
    static void mouse_button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
        if (action == GLFW_PRESS) of(window).input_.button_down(button, monotonic_s());
        if (action == GLFW_RELEASE) of(window).input_.button_up(button, monotonic_s());
    }
    static void refresh(GLFWwindow* window) { of(window).damaged_ = true; }
    static void close(GLFWwindow* window) { glfwSetWindowShouldClose(window, GLFW_FALSE); }
};

Window::Window(const WindowOptions& options) {
    if (glfwInit() != GLFW_TRUE) {
        throw base::failure("no display: {} ({}, {}); the kiosk needs a screen", glfw_reason(),
                            variable("DISPLAY"), variable("WAYLAND_DISPLAY"));
    }
    try {
        GLFWmonitor* monitor = find_monitor(options.monitor);
        const Extent place = size_of(monitor);
        require_room(place, options.room,
                     fmt::format("monitor {} ({})", options.monitor, glfwGetMonitorName(monitor)));
        Extent wanted = place;
        if (options.windowed) {
            wanted.width =
                std::min(place.width, std::max(options.room.width, kSmallestWindow.width));
            wanted.height =
                std::min(place.height, std::max(options.room.height, kSmallestWindow.height));
        } else if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) {
            glfwWindowHint(GLFW_REFRESH_RATE, mode->refreshRate);
        }
        set_hints();
        window_ = glfwCreateWindow(wanted.width, wanted.height, "Obscura",
                                   options.windowed ? nullptr : monitor, nullptr);
        if (window_ == nullptr) {
            throw base::failure(
                "no OpenGL 4.5 core context in a window: {}; the driver is missing or too old "
                "(Mesa's is in the package libgl1-mesa-dri)",
                glfw_reason());
        }
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window_, this);
        glfwSetKeyCallback(window_, &Callbacks::key);
        glfwSetCharCallback(window_, &Callbacks::character);
        glfwSetMouseButtonCallback(window_, &Callbacks::mouse_button);
        glfwSetWindowRefreshCallback(window_, &Callbacks::refresh);
        glfwSetWindowCloseCallback(window_, &Callbacks::close);
        glfwFocusWindow(window_);
        glfwPollEvents();
        require_room(size(), options.room, "the window");
        gpu_renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        describe_display(monitor, options.windowed);
    } catch (...) {
        if (window_ != nullptr) glfwDestroyWindow(window_);
        glfwTerminate();
        throw;
    }
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::describe_display(GLFWmonitor* monitor, bool windowed) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    refresh_hz_ = mode != nullptr ? std::max(0, mode->refreshRate) : 0;
    const std::string rate =
        refresh_hz_ > 0.0 ? fmt::format("{} Hz", refresh_hz_) : "unknown refresh rate";
    display_ =
        fmt::format("{} {} {}", glfwGetMonitorName(monitor), text_of(size_of(monitor)), rate);
    if (windowed) display_ += fmt::format(", window {}", text_of(size()));
}

Extent Window::size() const {
    Extent extent;
    glfwGetFramebufferSize(window_, &extent.width, &extent.height);
    return extent;
}

void Window::wait_for_events(double timeout_s) { glfwWaitEventsTimeout(std::max(1e-4, timeout_s)); }

void Window::poll_events() { glfwPollEvents(); }

bool Window::take_damage() { return std::exchange(damaged_, false); }

void Window::hide_pointer() { glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_HIDDEN); }

double Window::present() {
    glfwSwapBuffers(window_);
    glFinish();
    return monotonic_s();
}

}  // namespace obscura::app::kiosk
