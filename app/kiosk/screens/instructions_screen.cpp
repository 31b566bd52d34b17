// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> instructions_screen(const Fonts& fonts, const stimuli::Study& study) {
    std::optional<Event> event;
    card(
        "##instructions", 36.0F,
        [&] {
            heading(fonts, words()("instructions"));
            paragraph(study.instructions);
        },
        [&] {
            if (primary_button(words()("begin_experiment"))) event = InstructionsRead{};
        });
    return event;
}

}  // namespace obscura::app::kiosk
