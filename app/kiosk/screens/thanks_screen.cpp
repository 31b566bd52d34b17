// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

void thanks_screen(const Fonts& fonts, const stimuli::Study& study, const std::string& saved_note) {
    card(
        "##thanks", 30.0F,
        [&] {
            heading(fonts, words()("thank_you"));
            paragraph(study.thanks.empty() ? words()("thanks") : study.thanks);
            gap(0.2F);
            paragraph(saved_note);
        },
        [&] { hint(fonts, words()("thanks_keys")); });
}

}  // namespace obscura::app::kiosk
