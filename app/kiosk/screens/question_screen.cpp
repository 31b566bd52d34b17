// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> question_screen(const Fonts& fonts, const stimuli::Study& study, int pair,
                                     int count) {
    std::optional<Event> event;
    const auto body = [&] {
        hint(fonts, fmt::format("Image pair {} of {}", pair + 1, count));
        heading(fonts, study.question);
    };
    const auto foot = [&] {
        const float space = ImGui::GetFontSize();
        const float width = (ImGui::GetContentRegionAvail().x - space) * 0.5F;
        if (wide_button("First image", width, 4.0F, true)) event = Answered{true};
        ImGui::SameLine(0.0F, space);
        if (wide_button("Second image", width, 4.0F, true)) event = Answered{false};
        gap(0.3F);
        hint(fonts,
             "Click, or press 1 or the left arrow for the first, 2 or the right arrow for the "
             "second.");
    };
    // What ended the look at the second image must not press a button here.
    card("##question", 34.0F, body, foot, Keyboard::kIsLeftToTheCaller);
    return event;
}

}  // namespace obscura::app::kiosk
