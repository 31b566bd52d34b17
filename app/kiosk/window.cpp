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
#include "app/kiosk/key_names.h"
#include "app/kiosk/keyboard_grab.h"
#include "app/kiosk/response_box.h"
#include "app/window/glfw.h"
#include "renderer/base/error.h"

namespace obscura::app::kiosk {
namespace {

[[nodiscard]] std::string text_of(Extent extent) {
    return fmt::format("{}x{}", extent.width, extent.height);
}

[[nodiscard]] Extent size_of(GLFWmonitor* monitor) {
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    return mode != nullptr ? Extent{mode->width, mode->height} : Extent{};
}

[[nodiscard]] GLFWmonitor* find_monitor(const WindowOptions& wanted) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    if (count == 0) throw base::failure("no monitor is connected to this display");
    const int index = wanted.monitor;
    const bool by_name = !wanted.monitor_name.empty();
    if (!by_name && index >= 0 && index < count) return monitors[index];
    for (int i = 0; by_name && i < count; ++i) {
        if (wanted.monitor_name == glfwGetMonitorName(monitors[i])) return monitors[i];
    }
    std::string known;
    for (int i = 0; i < count; ++i) {
        known += fmt::format("{}{} ({} {})", i == 0 ? "" : ", ", i, glfwGetMonitorName(monitors[i]),
                             text_of(size_of(monitors[i])));
    }
    throw base::bad_input("--monitor: {} is not connected, there is {}",
                          by_name ? wanted.monitor_name : std::to_string(index), known);
}

void require_room(Extent place, Extent room, const std::string& what) {
    if (place.width >= room.width && place.height >= room.height) return;
    throw base::bad_input(
        "{} is {}, the images are {}: they are shown at 1:1 pixels and do not fit", what,
        text_of(place), text_of(room));
}

void set_hints() {
    window::ask_for_context();
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
    // The place of a click is where the pointer was by then, not where it is when it is drawn.
    static void pointer(GLFWwindow* window, double x, double y) {
        of(window).input_.pointer_moves({x, y});
    }
    static void mouse_button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
        if (action == GLFW_PRESS) of(window).input_.button_down(button, monotonic_s());
        if (action != GLFW_RELEASE) return;
        of(window).input_.button_up(button, monotonic_s());
        // Without a window manager a click alone brings no window to the keys.
        if (!of(window).focused_) glfwFocusWindow(window);
    }
    static void refresh(GLFWwindow* window) { of(window).damaged_ = true; }
    static void focus(GLFWwindow* window, int focused) {
        of(window).focused_ = focused == GLFW_TRUE;
    }
    static void iconify(GLFWwindow* window, int iconified) {
        of(window).iconified_ = iconified == GLFW_TRUE;
    }
    static void moved(GLFWwindow* window, int /*x*/, int /*y*/) { of(window).looked_s_ = 0.0; }
    static void close(GLFWwindow* window) { glfwSetWindowShouldClose(window, GLFW_FALSE); }
};

const char* to_string(Sight sight) {
    switch (sight) {
        case Sight::kClear:
            return "";
        case Sight::kMonitorLost:
            return "monitor lost";
        case Sight::kResized:
            return "resized";
        case Sight::kIconified:
            return "iconified";
        case Sight::kCovered:
            return "covered";
        case Sight::kLostFocus:
            return "lost focus";
    }
    return "";
}

Window::Window(const WindowOptions& options) {
    window::start_glfw("the kiosk");
    try {
        open(options);
        settle();
        if (!windowed_) has_all_keys_ = grab_keyboard(window_);
        require_room(size(), options.room, "the window");
        gpu_renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        describe_display();
    } catch (...) {
        cover_.reset();
        if (window_ != nullptr) glfwDestroyWindow(window_);
        glfwTerminate();
        throw;
    }
}

Window::~Window() {
    cover_.reset();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::open(const WindowOptions& options) {
    GLFWmonitor* monitor = find_monitor(options);
    monitor_name_ = glfwGetMonitorName(monitor);
    monitor_size_ = size_of(monitor);
    windowed_ = options.windowed;
    patch_ = options.patch;
    require_room(monitor_size_, options.room,
                 fmt::format("monitor {} ({})", options.monitor, monitor_name_));
    glfwGetMonitorPos(monitor, &wanted_.left, &wanted_.top);
    wanted_.size = monitor_size_;
    if (windowed_) {
        wanted_.size.width =
            std::min(monitor_size_.width, std::max(options.room.width, kSmallestWindow.width));
        wanted_.size.height =
            std::min(monitor_size_.height, std::max(options.room.height, kSmallestWindow.height));
    } else if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) {
        glfwWindowHint(GLFW_REFRESH_RATE, mode->refreshRate);
    }
    set_hints();
    window_ = glfwCreateWindow(wanted_.size.width, wanted_.size.height, "Obscura",
                               windowed_ ? nullptr : monitor, nullptr);
    if (window_ == nullptr) throw window::no_context();
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    set_callbacks();
    cover_ = std::make_unique<CoverWatch>(window_);
    swap_clock_ = std::make_unique<SwapClock>(window_);
    glfwFocusWindow(window_);
}

void Window::set_callbacks() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, &Callbacks::key);
    glfwSetCharCallback(window_, &Callbacks::character);
    glfwSetCursorPosCallback(window_, &Callbacks::pointer);
    glfwSetMouseButtonCallback(window_, &Callbacks::mouse_button);
    glfwSetWindowRefreshCallback(window_, &Callbacks::refresh);
    glfwSetWindowCloseCallback(window_, &Callbacks::close);
    glfwSetWindowFocusCallback(window_, &Callbacks::focus);
    glfwSetWindowIconifyCallback(window_, &Callbacks::iconify);
    glfwSetWindowPosCallback(window_, &Callbacks::moved);
    glfwSetFramebufferSizeCallback(window_, &Callbacks::moved);
}

/// Waits until the window is in its place and has the keys, for as long as something happens to it
/// and a little longer. Without the keys it goes on: a page then says so.
void Window::settle() {
    constexpr double kQuiet_s = 5.0;
    constexpr double kLongest_s = 30.0;
    const double began_s = monotonic_s();
    double last_event_s = began_s;
    focused_ = glfwGetWindowAttrib(window_, GLFW_FOCUSED) == GLFW_TRUE;
    Place before = place();
    while (!is_in_place() || !focused_) {
        const double now_s = monotonic_s();
        if (now_s - last_event_s > kQuiet_s || now_s - began_s > kLongest_s) break;
        glfwWaitEventsTimeout(0.05);
        const bool had_focus =
            std::exchange(focused_, glfwGetWindowAttrib(window_, GLFW_FOCUSED) == GLFW_TRUE);
        const Place after = place();
        if (after != before || focused_ != had_focus) last_event_s = monotonic_s();
        before = after;
    }
    // A plain window may be what the window manager makes of it, if the images have room.
    if (windowed_) wanted_.size = size();
    if (!is_in_place()) {
        throw base::failure("the window does not come to fill the monitor: {}", state());
    }
}

void Window::describe_display() {
    GLFWmonitor* its = monitor();
    const GLFWvidmode* mode = its != nullptr ? glfwGetVideoMode(its) : nullptr;
    refresh_hz_ = mode != nullptr ? std::max(0, mode->refreshRate) : 0;
    const std::string rate =
        refresh_hz_ > 0.0 ? fmt::format("{} Hz", refresh_hz_) : "unknown refresh rate";
    display_ = fmt::format("{} {} {}", monitor_name_, text_of(monitor_size_), rate);
    if (windowed_) display_ += fmt::format(", window {}", text_of(size()));
}

Window::Place Window::place() const {
    Place place;
    glfwGetWindowPos(window_, &place.left, &place.top);
    place.size = size();
    return place;
}

bool Window::is_in_place() const { return windowed_ ? size() == wanted_.size : place() == wanted_; }

GLFWmonitor* Window::monitor() const {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    GLFWmonitor** end = monitors + count;
    GLFWmonitor** found = std::find_if(monitors, end, [this](GLFWmonitor* one) {
        return monitor_name_ == glfwGetMonitorName(one);
    });
    return found != end ? *found : nullptr;
}

Sight Window::sight() {
    constexpr double kLook_s = 0.25;
    if (const double now_s = monotonic_s(); now_s - looked_s_ >= kLook_s) {
        looked_s_ = now_s;
        in_place_ = is_in_place();
        GLFWmonitor* its = monitor();
        monitor_lost_ = its == nullptr;
        monitor_as_it_was_ = its != nullptr && size_of(its) == monitor_size_;
    }
    if (monitor_lost_) return Sight::kMonitorLost;
    if (iconified_) return Sight::kIconified;
    if (!monitor_as_it_was_ || !in_place_) return Sight::kResized;
    if (cover_->covered()) return Sight::kCovered;
    return focused_ ? Sight::kClear : Sight::kLostFocus;
}

std::string Window::state() const {
    const Place now = place();
    GLFWmonitor* its = monitor();
    const std::string is = its == nullptr ? "gone" : text_of(size_of(its));
    return fmt::format(
        "the monitor {} is {}, it was {}; the window is {} at {}, {}, it should be {} at {}, {}",
        monitor_name_, is, text_of(monitor_size_), text_of(now.size), now.left, now.top,
        text_of(wanted_.size), wanted_.left, wanted_.top);
}

/// A page can be read on whatever screen is left. GLFW itself leaves the window anywhere when its
/// monitor goes.
void Window::make_do_with(GLFWmonitor* monitor) {
    Place meanwhile = wanted_;
    if (const Extent extent = size_of(monitor); extent.width > 0 && extent.height > 0) {
        glfwGetMonitorPos(monitor, &meanwhile.left, &meanwhile.top);
        meanwhile.size = extent;
    }
    if (windowed_ || place() == meanwhile) return;
    const auto& [left, top, extent] = meanwhile;
    glfwSetWindowMonitor(window_, nullptr, left, top, extent.width, extent.height, GLFW_DONT_CARE);
}

void Window::restore() {
    looked_s_ = 0.0;
    GLFWmonitor* its = monitor();
    if (its == nullptr || size_of(its) != monitor_size_) {
        make_do_with(its != nullptr ? its : glfwGetPrimaryMonitor());
        return;
    }
    if (windowed_) {
        if (!is_in_place()) glfwSetWindowSize(window_, wanted_.size.width, wanted_.size.height);
        return;
    }
    if (iconified_) {
        glfwRestoreWindow(window_);
        return;
    }
    if (!is_in_place()) {
        // To the monitor by way of a plain window: GLFW asks for nothing that it believes it has.
        const auto& [left, top, extent] = wanted_;
        const GLFWvidmode* mode = glfwGetVideoMode(its);
        const int rate = mode != nullptr ? mode->refreshRate : GLFW_DONT_CARE;
        glfwSetWindowMonitor(window_, nullptr, left, top, extent.width, extent.height, rate);
        glfwSetWindowMonitor(window_, its, 0, 0, extent.width, extent.height, rate);
    }
    glfwFocusWindow(window_);
    has_all_keys_ = grab_keyboard(window_);
}

Extent Window::size() const {
    Extent extent;
    glfwGetFramebufferSize(window_, &extent.width, &extent.height);
    return extent;
}

void Window::wait_for_events(double timeout_s) {
    glfwWaitEventsTimeout(std::max(1e-4, timeout_s));
    take_box_presses();
}

void Window::poll_events() {
    glfwPollEvents();
    take_box_presses();
}

void Window::take_box_presses() {
    if (box_ == nullptr) return;
    for (const ResponseBox::Press& press : box_->take()) {
        input_.key_down({key_named(press.key), 0, press.time_s});
    }
}

/// In the lower left corner, a twelfth of the height.
void Window::draw_patch() const {
    constexpr int kPart = 12;
    const int side = size().height / kPart;
    const float level = lit_ ? 1.0F : 0.0F;
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, side, side);
    glClearColor(level, level, level, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

bool Window::take_damage() { return std::exchange(damaged_, false); }

void Window::hide_pointer() { glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_HIDDEN); }

double Window::present() {
    if (patch_) draw_patch();
    glfwSwapBuffers(window_);
    return swap_clock_->shown_s();
}

}  // namespace obscura::app::kiosk
