// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <cmath>
#include <string>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> question_screen(const Fonts& fonts, const stimuli::Study& study, int pair,
                                     int count) {
    std::optional<Event> event;
    const auto body = [&] {
        hint(fonts, words()("pair_of", {{"pair", std::to_string(pair + 1)},
                                        {"count", std::to_string(count)}}));
        heading(fonts, study.question);
    };
    const auto foot = [&] {
        const float space = ImGui::GetFontSize();
        const float width = std::floor((ImGui::GetContentRegionAvail().x - space) * 0.5F);
        SideBySide row(space);
        row.next(width);
        if (wide_button(words()("first_image"), width, 4.0F, true)) event = Answered{true};
        row.next(width);
        if (wide_button(words()("second_image"), width, 4.0F, true)) event = Answered{false};
        gap(0.3F);
        hint(fonts, words()("question_hint"));
    };
    // What ended the look at the second image must not press a button here.
    card("##question", 34.0F, body, foot, Keyboard::kIsLeftToTheCaller);
    return event;
}

}  // namespace obscura::app::kiosk
