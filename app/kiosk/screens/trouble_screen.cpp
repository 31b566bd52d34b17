// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>
// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/kiosk/screens/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {

std::optional<TroubleChoice> trouble_screen(const Fonts& fonts, const Trouble& trouble) {
    std::optional<TroubleChoice> choice;
    card("##trouble", 36.0F, [&] {
        hint(fonts, "Please call the person in charge");
        heading(fonts, trouble.title);
        complaint(trouble.reason);
        paragraph(trouble.consequence);
        gap();
        const float space = ImGui::GetFontSize();
        const float width = (ImGui::GetContentRegionAvail().x - space) * 0.5F;
        if (wide_button("Leave the kiosk", width, 2.1F, false)) choice = TroubleChoice::kLeave;
        ImGui::SameLine(0.0F, space);
        if (wide_button("Try again", width, 2.1F, true)) choice = TroubleChoice::kRetry;
        if (enter_pressed()) choice = TroubleChoice::kRetry;
        if (ImGui::IsKeyPressed(GLFW_KEY_L, false)) choice = TroubleChoice::kLeave;
        gap(0.2F);
        hint(fonts, "Keys: L leaves, Enter tries again.");
    });
    return choice;
}

std::vector<std::string> fixed_texts() { return {"\u2713"}; }

}  // namespace obscura::app::kiosk
