// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/kiosk/page.h"
#include "app/kiosk/window.h"
#include "app/window/fonts.h"

namespace obscura::app::kiosk {

using window::Fonts;

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

    /// The next page begins: at its top, nothing of it seen, and it sees nothing of the input
    /// until that is opened.
    void begin_page();

    /// Draws a page into the frame; it is not presented yet. `page` calls Dear ImGui.
    void draw(const std::function<void()>& page);

    /// Whether the page's end was in view.
    [[nodiscard]] bool end_seen() const { return page_.end_seen; }
    /// What the page saw of keyboard and mouse in the frame that was drawn last.
    [[nodiscard]] const InputFrame& input() const { return page_.input; }

  private:
    void hand_over_input();

    Window& window_;
    PageState page_;
    int grey_level_;
    Fonts fonts_;
};

}  // namespace obscura::app::kiosk
