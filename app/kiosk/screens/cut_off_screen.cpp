// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>
// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/kiosk/screens/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

[[nodiscard]] std::string continue_label(const CutOffSession& session) {
    if (session.answered == session.count) return "Complete it: every pair is answered";
    return fmt::format("Continue at pair {}", session.answered + 1);
}

}  // namespace

std::optional<CutOffChoice> cut_off_screen(const Fonts& fonts, const CutOffSession& session) {
    std::optional<CutOffChoice> choice;
    card("##cut-off", 34.0F, [&] {
        hint(fonts, "For the operator");
        heading(fonts, "The last run was cut off");
        paragraph(fmt::format("Session {} began at {} and has {} of {} answers.",
                              session.session_id, session.started_utc, session.answered,
                              session.count));
        if (!session.refusal.empty()) {
            complaint("It cannot be continued: " + session.refusal + ".");
        }
        gap(0.5F);
        if (session.refusal.empty()) {
            if (primary_button(continue_label(session).c_str())) choice = CutOffChoice::kContinue;
        }
        const char* label = "Close it as abandoned";
        const float width = ImGui::CalcTextSize(label).x + 4.0F * ImGui::GetFontSize();
        ImGui::SetCursorPosX((ImGui::GetWindowWidth() - width) * 0.5F);
        if (wide_button(label, width, 2.1F, false)) choice = CutOffChoice::kAbandon;
        if (key_pressed(GLFW_KEY_A)) choice = CutOffChoice::kAbandon;
        gap(0.2F);
        hint(fonts,
             session.refusal.empty() ? "Keys: Enter continues, A abandons." : "Key: A abandons.");
    });
    return choice;
}

}  // namespace obscura::app::kiosk
