// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "stimuli/png.h"

namespace obscura::app::kiosk {

/// A child process; killed at the end of its life if it still runs.
class ChildProcess {
  public:
    ChildProcess() = default;
    /// `descriptor` of this process stays open in the child; -1: none. stderr goes to `log`, where
    /// that is not empty.
    ChildProcess(const std::vector<std::string>& command, int descriptor, const std::string& log);
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;

    void kill(int signal) const;
    /// Whether it ended within that time; then `exit_code` is its code, or 128 + signal.
    [[nodiscard]] bool wait(double seconds, int& exit_code);

  private:
    pid_t id_ = 0;
};

/// An X server without a screen (Xvfb), which DISPLAY names while it lives. Each test has its own.
class VirtualDisplay {
  public:
    VirtualDisplay(int width, int height);

    /// What is on the screen, the pointer left out.
    [[nodiscard]] stimuli::RgbImage screen() const;
    /// A key as the keyboard sends it, in xdotool's words: space, Return, ctrl+shift+q.
    void key(const std::string& name) const;
    /// One after another, as fast as people type.
    void keys(const std::vector<std::string>& names) const;
    void click(int x, int y) const;
    /// Two clicks as people double-click.
    void double_click(int x, int y) const;
    /// A key that is held, with the repeats of the server.
    void hold(const std::string& key, double seconds) const;
    /// Runs a tool that talks to the display (xdotool, xrandr, setxkbmap) and waits for its end.
    void tool(const std::vector<std::string>& command) const;
    /// Openbox, which takes part in where windows are and which has the keys. An empty `config`:
    /// with its usual keys and menus, of which one ends it.
    void start_window_manager(const std::string& config = "");
    /// Asks every window to close, as a window manager does (WM_DELETE_WINDOW).
    void ask_windows_to_close() const;

  private:
    int width_;
    int height_;
    ChildProcess server_;
    ChildProcess manager_;
};

/// Another program's window on the display, before all others and out of a window manager's care.
class OtherWindow {
  public:
    OtherWindow(int left, int top, int width, int height);
    ~OtherWindow();
    OtherWindow(const OtherWindow&) = delete;
    OtherWindow& operator=(const OtherWindow&) = delete;

    void take_focus() const;

  private:
    void* connection_;
    unsigned long window_;
};

}  // namespace obscura::app::kiosk
