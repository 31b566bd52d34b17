// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "app/kiosk/cover_watch.h"
#include "app/kiosk/input.h"
#include "app/kiosk/swap_clock.h"

struct GLFWwindow;
struct GLFWmonitor;

namespace obscura::app::kiosk {

class ResponseBox;

/// Width and height in pixels.
struct Extent {
    int width = 0;
    int height = 0;
    bool operator==(const Extent&) const = default;
};

/// What the pages need; a plain window is at least this large.
inline constexpr Extent kSmallestWindow{1024, 720};

struct WindowOptions {
    int monitor = 0;                ///< index of the monitor, from 0
    bool windowed = false;          ///< a plain window instead of the whole monitor
    Extent room;                    ///< the window must hold an image of this size at 1:1
    std::string monitor_name = {};  ///< instead of its index; empty: that
    bool patch = false;             ///< a square in a corner for a photodiode
};

/// What keeps a window from being seen whole and in front, and from the keys. Each but the first
/// is the name of an event.
enum class Sight { kClear, kMonitorLost, kResized, kIconified, kCovered, kLostFocus };
/// `monitor lost`, `resized`, `iconified`, `covered`, `lost focus`; nothing for kClear.
[[nodiscard]] const char* to_string(Sight sight);

/// The one window with its OpenGL 4.5 core context, which is current while the window lives.
/// Closing it by the window manager does nothing. One at a time.
class Window {
  public:
    /// Returns when the window is where it belongs: a window manager brings it there in its own
    /// time. Throws failure when there is no display or no driver, naming it, or when the window
    /// does not come to fill the monitor, saying where it is instead; bad input when the monitor
    /// does not exist or is smaller than `room`, naming both sizes.
    explicit Window(const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
    [[nodiscard]] const std::string& monitor_name() const { return monitor_name_; }
    [[nodiscard]] Extent monitor_size() const { return monitor_size_; }
    /// Whether all keys come here, also those of the window manager: of a whole monitor only.
    [[nodiscard]] bool has_all_keys() const { return has_all_keys_; }
    /// In pixels.
    [[nodiscard]] Extent size() const;
    [[nodiscard]] const std::string& gpu_renderer() const { return gpu_renderer_; }
    /// Monitor's name, resolution, refresh rate, whole monitor or window.
    [[nodiscard]] const std::string& display() const { return display_; }
    /// As the monitor says; 0 where it does not.
    [[nodiscard]] double refresh_hz() const { return refresh_hz_; }

    /// Lets events in; returns at the latest after that time.
    void wait_for_events(double timeout_s);
    void poll_events();
    /// Takes what the box sends for keys from now on; it must outlive the window's events.
    void listen_to(ResponseBox* box) { box_ = box; }
    /// With WindowOptions::patch: white from the next present() on, or black.
    void light_patch(bool lit) { lit_ = lit; }
    /// What keyboard and mouse did.
    [[nodiscard]] Input& input() { return input_; }
    /// Whether the system lost what was drawn, so that it must be drawn again; asked once.
    [[nodiscard]] bool take_damage();
    void hide_pointer();

    /// As far as this can be known (CoverWatch says what cannot); the graver before the lesser. The
    /// monitor and the window's place are asked for at most every quarter of a second.
    [[nodiscard]] Sight sight();
    /// How the monitor and the window are and how they should be: for the operator.
    [[nodiscard]] std::string state() const;
    /// Brings the window back, as far as it can be: where it belongs, and on the whole monitor also
    /// back from an icon, before other windows and to the keys. Where the monitor is gone or is not
    /// as it was, the window fills what is there instead. Never changes the monitor.
    void restore();

    /// Shows what was drawn and waits until it is shown; gives the monotonic time.
    double present();
    /// Of present(), as SwapClock names it.
    [[nodiscard]] const char* time_source() const { return swap_clock_->source(); }

  private:
    struct Callbacks;

    /// Where the window is, in the screen's pixels.
    struct Place {
        int left = 0;
        int top = 0;
        Extent size;
        bool operator==(const Place&) const = default;
    };

    void open(const WindowOptions& options);
    void settle();
    void set_callbacks();
    void describe_display();
    void take_box_presses();
    void draw_patch() const;
    [[nodiscard]] Place place() const;
    [[nodiscard]] bool is_in_place() const;
    /// The window's; nullptr: it is gone. Looked for anew each time: GLFW frees a monitor that
    /// goes, and Dear ImGui takes its only callback for monitors.
    [[nodiscard]] GLFWmonitor* monitor() const;
    void make_do_with(GLFWmonitor* monitor);

    GLFWwindow* window_ = nullptr;
    std::string monitor_name_;
    bool windowed_ = false;
    Place wanted_;         ///< of the window; its size only where it is windowed
    Extent monitor_size_;  ///< as it was at first
    std::unique_ptr<CoverWatch> cover_;
    std::unique_ptr<SwapClock> swap_clock_;
    ResponseBox* box_ = nullptr;
    bool has_all_keys_ = false;
    bool patch_ = false;
    bool lit_ = false;
    bool focused_ = true;
    bool iconified_ = false;
    bool in_place_ = true;
    bool monitor_lost_ = false;
    bool monitor_as_it_was_ = true;
    double looked_s_ = 0.0;  ///< when the place and the monitor were last asked for
    std::string gpu_renderer_;
    std::string display_;
    double refresh_hz_ = 0.0;
    Input input_;
    bool damaged_ = false;
};

}  // namespace obscura::app::kiosk
