// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screens/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> thanks_screen(const Fonts& fonts, const stimuli::Study& study,
                                   const std::string& saved_note) {
    std::optional<Event> event;
    card("##thanks", 30.0F, [&] {
        heading(fonts, "Thank you");
        paragraph(
            study.thanks.empty()
                ? "That was the last pair. Please tell the person in charge that you are done."
                : study.thanks);
        gap(0.2F);
        hint(fonts, saved_note);
        gap();
        if (primary_button("Next participant")) event = NextParticipant{};
    });
    return event;
}

}  // namespace obscura::app::kiosk
