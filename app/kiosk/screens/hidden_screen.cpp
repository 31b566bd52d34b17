// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

void hidden_screen(const Fonts& fonts, Sight why, const std::string& state) {
    card("##hidden", 34.0F, [&] {
        heading(fonts, words()("one_moment"));
        if (why == Sight::kMonitorLost || why == Sight::kResized) {
            paragraph(words()("screen_changed"));
            gap(0.2F);
            paragraph(words()("operators_key"));
            hint(fonts, state);
        } else {
            paragraph(words()("window_covered"));
            gap(0.2F);
            paragraph(words()("operators_key"));
        }
    });
}

}  // namespace obscura::app::kiosk
