// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

bool trouble_screen(const Fonts& fonts, const Trouble& trouble) {
    bool again = false;
    card("##trouble", 36.0F, [&] {
        hint(fonts, "Please call the person in charge");
        heading(fonts, trouble.title);
        complaint(trouble.reason);
        gap(0.2F);
        paragraph(trouble.consequence);
        gap();
        if (primary_button("Try again")) again = true;
        gap(0.2F);
        hint(fonts, "The operator leaves with Ctrl+Shift+Q.");
    });
    return again;
}

std::vector<std::string> fixed_texts() { return {"\u2190 \u25A1 \u2713"}; }

}  // namespace obscura::app::kiosk
