// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

void saving_screen(const Fonts& fonts) {
    card("##saving", 24.0F, [&] {
        heading(fonts, "Saving\u2026");
        paragraph("One moment, please. It goes on by itself.");
    });
}

}  // namespace obscura::app::kiosk
