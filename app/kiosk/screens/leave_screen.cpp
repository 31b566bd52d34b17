// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>
// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> leave_screen(const Fonts& fonts, bool session_open) {
    std::optional<Event> event;
    const auto body = [&] {
        heading(fonts, words()("leave_title"));
        paragraph(words()(session_open ? "leave_open" : "leave_closed"));
    };
    const auto foot = [&] {
        const float space = ImGui::GetFontSize();
        const float width = std::floor((ImGui::GetContentRegionAvail().x - space) * 0.5F);
        SideBySide row(space);
        row.next(width);
        if (wide_button(words()("leave"), width, 2.1F, false)) event = LeaveConfirmed{};
        row.next(width);
        if (wide_button(words()("stay"), width, 2.1F, true)) event = LeaveCancelled{};
        if (enter_pressed() || key_pressed(GLFW_KEY_ESCAPE)) event = LeaveCancelled{};
        if (letter_pressed('l')) event = LeaveConfirmed{};
        gap(0.2F);
        paragraph(words()("leave_keys"));
    };
    card("##leave", 32.0F, body, foot);
    return event;
}

}  // namespace obscura::app::kiosk
