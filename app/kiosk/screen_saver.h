// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::app::kiosk {

/// Holds off screen saver and power saving while it lives, and gives them back at its end: by the
/// desktop's org.freedesktop.ScreenSaver on the session's D-Bus where one answers, else by the X
/// server, which gives them back by itself also where the program is killed.
class ScreenSaverHold {
  public:
    ScreenSaverHold();
    ~ScreenSaverHold();
    ScreenSaverHold(const ScreenSaverHold&) = delete;
    ScreenSaverHold& operator=(const ScreenSaverHold&) = delete;

    /// What holds them off: `org.freedesktop.ScreenSaver` or `the X server`; empty: nothing does.
    [[nodiscard]] const std::string& by() const { return by_; }

  private:
    [[nodiscard]] bool ask_desktop();
    [[nodiscard]] bool ask_server();

    std::string by_;
    void* bus_ = nullptr;      ///< GDBusConnection*
    unsigned cookie_ = 0;      ///< that the desktop gave
    void* display_ = nullptr;  ///< Display*, a connection of its own
};

}  // namespace obscura::app::kiosk
