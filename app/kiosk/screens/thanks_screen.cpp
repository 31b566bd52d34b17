// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> thanks_screen(const Fonts& fonts) {
    std::optional<Event> event;
    card("##thanks", 30.0F, [&] {
        heading(fonts, "Thank you");
        paragraph("That was the last pair. All your answers are saved.");
        paragraph("Please tell the person in charge that you are done.");
        gap();
        if (primary_button("Next participant")) event = NextParticipant{};
    });
    return event;
}

}  // namespace obscura::app::kiosk
