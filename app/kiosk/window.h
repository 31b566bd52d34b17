// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/kiosk/input.h"

struct GLFWwindow;
struct GLFWmonitor;

namespace obscura::app::kiosk {

/// Width and height in pixels.
struct Extent {
    int width = 0;
    int height = 0;
};

struct WindowOptions {
    int monitor = 0;        ///< index of the monitor, from 0
    bool windowed = false;  ///< a plain window instead of the whole monitor
    Extent room;            ///< the window must hold an image of this size at 1:1
};

/// The one window with its OpenGL 4.5 core context, which is current while the window lives.
/// Closing it by the window manager does nothing. One at a time.
class Window {
  public:
    /// Throws failure when there is no display or no driver, naming it; bad input when the monitor
    /// does not exist or is smaller than `room`, naming both sizes.
    explicit Window(const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
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
    /// What keyboard and mouse did.
    [[nodiscard]] Input& input() { return input_; }
    /// Whether the system lost what was drawn, so that it must be drawn again; asked once.
    [[nodiscard]] bool take_damage();
    void hide_pointer();

    /// Shows what was drawn and waits until it is shown; gives the monotonic time.
    double present();

  private:
    struct Callbacks;

    void describe_display(GLFWmonitor* monitor, bool windowed);

    GLFWwindow* window_ = nullptr;
    std::string gpu_renderer_;
    std::string display_;
    double refresh_hz_ = 0.0;
    Input input_;
    bool damaged_ = false;
};

}  // namespace obscura::app::kiosk
