// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <cmath>
#include <string>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> question_screen(const Fonts& fonts, const stimuli::Study& study,
                                     const Progress& at) {
    std::optional<Event> event;
    const bool beside = study.presentation.layout == stimuli::Layout::kSideBySide;
    // The first is where reading begins.
    const char* const left = is_mirrored() ? "right_image" : "left_image";
    const char* const right = is_mirrored() ? "left_image" : "right_image";
    const auto body = [&] {
        hint(fonts,
             words()(at.practice ? "practice_pair_of" : "pair_of",
                     {{"pair", std::to_string(at.pair + 1)}, {"count", std::to_string(at.count)}}));
        heading(fonts, study.question);
    };
    const auto foot = [&] {
        const float space = ImGui::GetFontSize();
        const float width = std::floor((ImGui::GetContentRegionAvail().x - space) * 0.5F);
        SideBySide row(space);
        row.next(width);
        if (wide_button(words()(beside ? left : "first_image"), width, 4.0F, true))
            event = Answered{true};
        row.next(width);
        if (wide_button(words()(beside ? right : "second_image"), width, 4.0F, true))
            event = Answered{false};
        gap(0.3F);
        hint(fonts, words()(beside ? "question_hint_beside" : "question_hint"));
    };
    // What ended the look at the second image must not press a button here.
    card("##question", 34.0F, body, foot, Keyboard::kIsLeftToTheCaller);
    return event;
}

}  // namespace obscura::app::kiosk
