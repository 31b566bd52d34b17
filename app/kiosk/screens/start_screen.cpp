// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> start_screen(const Fonts& fonts) {
    std::optional<Event> event;
    card(
        "##start", 32.0F,
        [&] {
            // The study's title stays untold: it may give its purpose away.
            heading(fonts, "Welcome");
            paragraph("Thank you for coming.");
            paragraph(
                "You will be asked a few questions about yourself, then the task is explained. "
                "Take all the time you need.");
        },
        [&] {
            if (primary_button("Begin")) event = StartPressed{};
            gap(0.2F);
            hint(fonts, kOperatorsKey);
        });
    return event;
}

}  // namespace obscura::app::kiosk
