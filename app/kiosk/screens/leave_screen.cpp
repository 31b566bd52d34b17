// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>
// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<Event> leave_screen(const Fonts& fonts, bool session_open) {
    std::optional<Event> event;
    const auto body = [&] {
        heading(fonts, "Leave the kiosk?");
        paragraph(session_open
                      ? "A session is under way. It stays open: at the next start it can be "
                        "continued at the first pair without an answer."
                      : "No session is under way.");
    };
    const auto foot = [&] {
        const float space = ImGui::GetFontSize();
        const float width = (ImGui::GetContentRegionAvail().x - space) * 0.5F;
        if (wide_button("Leave", width, 2.1F, false)) event = LeaveConfirmed{};
        ImGui::SameLine(0.0F, space);
        if (wide_button("Stay", width, 2.1F, true)) event = LeaveCancelled{};
        if (enter_pressed() || key_pressed(GLFW_KEY_ESCAPE)) event = LeaveCancelled{};
        if (letter_pressed('l')) event = LeaveConfirmed{};
        gap(0.2F);
        paragraph("Keys: L leaves, Enter stays.");
    };
    card("##leave", 32.0F, body, foot);
    return event;
}

}  // namespace obscura::app::kiosk
