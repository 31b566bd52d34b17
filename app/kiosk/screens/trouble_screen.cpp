// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

bool trouble_screen(const Fonts& fonts, const Trouble& trouble) {
    bool again = false;
    const auto body = [&] {
        heading(fonts, trouble.title);
        paragraph(words()("call_operator"));
        gap(0.5F);
        paragraph(trouble.consequence);
        paragraph(words()("operators_key"));
        gap(0.2F);
        hint(fonts, trouble.reason);
    };
    const auto foot = [&] {
        if (primary_button(words()("try_again"))) again = true;
    };
    card("##trouble", 36.0F, body, foot);
    return again;
}

}  // namespace obscura::app::kiosk
