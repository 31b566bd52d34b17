// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

bool trouble_screen(const Fonts& fonts, const Trouble& trouble) {
    bool again = false;
    const auto body = [&] {
        heading(fonts, trouble.title);
        paragraph("Please call the person in charge.");
        gap(0.5F);
        paragraph(trouble.consequence);
        paragraph(kOperatorsKey);
        gap(0.2F);
        hint(fonts, trouble.reason);
    };
    const auto foot = [&] {
        if (primary_button("Try again")) again = true;
    };
    card("##trouble", 36.0F, body, foot);
    return again;
}

std::vector<std::string> texts_of_pages(const stimuli::Study& study) {
    return {study.question, study.instructions, study.thanks, "\u2190 \u25A1 \u2713 \u2026"};
}

}  // namespace obscura::app::kiosk
