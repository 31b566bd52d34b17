// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

void thanks_screen(const Fonts& fonts, const stimuli::Study& study, const std::string& saved_note) {
    card(
        "##thanks", 30.0F,
        [&] {
            heading(fonts, "Thank you");
            paragraph(
                study.thanks.empty()
                    ? "That was the last pair. Please tell the person in charge that you are done."
                    : study.thanks);
            gap(0.2F);
            paragraph(saved_note);
        },
        [&] {
            hint(fonts,
                 "For the operator: Ctrl+Shift+N begins with the next participant, Ctrl+Shift+Q "
                 "leaves.");
        });
}

}  // namespace obscura::app::kiosk
