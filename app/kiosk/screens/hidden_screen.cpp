// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

void hidden_screen(const Fonts& fonts, Sight why, const std::string& state) {
    card("##hidden", 34.0F, [&] {
        heading(fonts, "One moment, please");
        if (why == Sight::kMonitorLost || why == Sight::kResized) {
            paragraph(
                "The screen has changed. Please call the person in charge: when it is as it was "
                "before, this goes on where it was.");
            gap(0.2F);
            paragraph(kOperatorsKey);
            hint(fonts, state);
        } else {
            paragraph(
                "Another window came before this one. Click here, and it goes on where it was.");
            gap(0.2F);
            paragraph(kOperatorsKey);
        }
    });
}

}  // namespace obscura::app::kiosk
