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
            heading(fonts, words()("welcome"));
            paragraph(words()("welcome_thanks"));
            paragraph(words()("welcome_text"));
        },
        [&] {
            if (primary_button(words()("begin"))) event = StartPressed{};
            gap(0.2F);
            hint(fonts, words()("operators_key"));
        });
    return event;
}

}  // namespace obscura::app::kiosk
