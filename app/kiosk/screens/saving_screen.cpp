// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

void saving_screen(const Fonts& fonts) {
    card("##saving", 24.0F, [&] {
        heading(fonts, words()("saving"));
        paragraph(words()("saving_text"));
    });
}

}  // namespace obscura::app::kiosk
