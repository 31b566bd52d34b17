// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/kiosk/fonts.h"
#include "app/kiosk/window.h"

namespace obscura::app::kiosk {

/// Dear ImGui in the kiosk's window: draws pages.
class Ui {
  public:
    /// `texts` are the study's, for their characters; `grey_level` is the surround. `window` must
    /// outlive it.
    Ui(Window& window, const std::vector<std::string>& texts, int grey_level);
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    [[nodiscard]] const Fonts& fonts() const { return fonts_; }

    /// Draws a page into the frame; it is not presented yet. `page` calls Dear ImGui.
    void draw(const std::function<void()>& page);

    /// Forgets a mouse button or key that went down before the page was visible.
    void forget_input();

  private:
    void take_short_taps();

    Window& window_;
    std::vector<int> tapped_;  ///< keys shown to Dear ImGui as down in the last frame
    int grey_level_;
    Fonts fonts_;
};

}  // namespace obscura::app::kiosk
