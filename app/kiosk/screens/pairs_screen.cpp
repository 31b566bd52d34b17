// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/kiosk/screens/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

/// Columns of buttons for that many pairs: one up to seven, as in the thesis, then more.
[[nodiscard]] int columns_for(int count) { return std::clamp((count + 6) / 7, 1, 6); }

/// One pair's button; gives whether it was pressed.
[[nodiscard]] bool pair_button(int pair, int next, float width) {
    const bool is_next = pair == next;
    const std::string label =
        fmt::format("Image pair {}{}###pair{}", pair + 1, pair < next ? "   \u2713" : "", pair);
    ImGui::BeginDisabled(!is_next);
    const bool pressed = wide_button(label.c_str(), width, 1.9F, is_next);
    if (is_next) ImGui::SetItemDefaultFocus();
    ImGui::EndDisabled();
    return pressed;
}

}  // namespace

std::optional<Event> pairs_screen(const Fonts& fonts, int next, int count) {
    std::optional<Event> event;
    card("##pairs", 24.0F + 6.0F * static_cast<float>(columns_for(count) - 1), [&] {
        heading(fonts, "Image pairs");
        hint(fonts, next == 0 ? "Press the button of the first pair when you are ready."
                              : "Press the button of the next pair when you are ready.");
        gap(0.4F);
        const int columns = columns_for(count);
        const float space = ImGui::GetStyle().ItemSpacing.x;
        const float room = ImGui::GetContentRegionAvail().x;
        const float width =
            (room - space * static_cast<float>(columns - 1)) / static_cast<float>(columns);
        for (int pair = 0; pair < count; ++pair) {
            if (pair % columns != 0) ImGui::SameLine();
            if (pair_button(pair, next, width)) event = PairPressed{pair};
        }
        if (enter_pressed()) event = PairPressed{next};
        gap(0.2F);
        hint(fonts, fmt::format("{} of {} done", next, count));
    });
    return event;
}

}  // namespace obscura::app::kiosk
