// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

/// Times the text's height.
constexpr float kButtonHeight = 1.9F;
constexpr float kWideColumn = 9.0F;    ///< at least; else as wide as the whole label
constexpr float kNarrowColumn = 4.5F;  ///< holds the number
constexpr float kAround = 13.0F;       ///< of the window's height, what the list does not get
constexpr int kUsualRows = 7;
constexpr const char* kDone = "  \u2713";

struct Grid {
    int columns = 1;
    float column = kWideColumn;
    bool whole_labels = true;
};

[[nodiscard]] std::string whole_label(int pair) {
    return words()("pair", {{"pair", std::to_string(pair + 1)}});
}

/// One column up to seven pairs, as in the thesis; then as many as keep the list in view, of
/// numbers alone where whole labels have no room.
[[nodiscard]] Grid grid_for(int count) {
    const float text_px = ImGui::GetFontSize();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float row_px = kButtonHeight * text_px + ImGui::GetStyle().ItemSpacing.y;
    const int rows =
        std::max(kUsualRows, static_cast<int>((screen.y - kAround * text_px) / row_px));
    const int few = (count + kUsualRows - 1) / kUsualRows;
    const auto fitting = [&](float column) {
        const float room_px = screen.x - 8.0F * text_px;
        return std::max(1, static_cast<int>(room_px / (column * text_px)));
    };
    // With the mark of a pair that is done, and the button's padding.
    const float wide =
        std::max(kWideColumn, std::ceil(text_width(whole_label(count) + kDone) / text_px + 1.5F));
    const int most = fitting(wide);
    if (few <= std::min(most, 4)) return {few, wide, true};
    const int needed = (count + rows - 1) / rows;
    if (needed <= most) return {needed, wide, true};
    return {std::min(needed, fitting(kNarrowColumn)), kNarrowColumn, false};
}

/// One pair's button; gives whether it was pressed.
[[nodiscard]] bool pair_button(int pair, int next, const Grid& grid, float width) {
    const bool is_next = pair == next;
    const std::string label = (grid.whole_labels ? whole_label(pair) : std::to_string(pair + 1)) +
                              (pair < next ? kDone : "");
    // Not before the whole list was seen, should it ever be taller than the window.
    ImGui::BeginDisabled(!is_next || !page_state().end_seen);
    const bool pressed = wide_button(label, width, kButtonHeight, is_next);
    ImGui::EndDisabled();
    return pressed;
}

void head(const Fonts& fonts, const Progress& at) {
    heading(fonts, words()(at.practice ? "practice" : "pairs"));
    if (at.practice) paragraph(words()("practice_hint"));
    hint(fonts, words()(at.pair == 0 ? "first_pair_hint" : "next_pair_hint"));
    gap(0.4F);
}

/// How far it is, filled in the direction of reading.
void progress_bar(const Progress& at) {
    const float width = std::round(ImGui::GetContentRegionAvail().x);
    const float height = times_text(0.5F);
    const float filled =
        std::round(width * static_cast<float>(at.pair) / static_cast<float>(std::max(1, at.count)));
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float left = from.x + (is_mirrored() ? width - filled : 0.0F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + width, from.y + height},
                       ImGui::GetColorU32(ImGuiCol_FrameBg), 0.5F * height);
    list.AddRectFilled({left, from.y}, {left + filled, from.y + height},
                       ImGui::GetColorU32(ImGuiCol_CheckMark), 0.5F * height);
    ImGui::Dummy({width, height});
}

/// One button with the progress.
std::optional<Event> next_pair_screen(const Fonts& fonts, const Progress& at) {
    std::optional<Event> event;
    card(
        "##pairs", 26.0F,
        [&] {
            head(fonts, at);
            progress_bar(at);
            hint(fonts, words()("done", {{"done", std::to_string(at.pair)},
                                         {"count", std::to_string(at.count)}}));
        },
        [&] {
            if (primary_button(words()("next_pair"))) event = PairPressed{at.pair};
        });
    return event;
}

}  // namespace

std::optional<Event> pairs_screen(const Fonts& fonts, const Progress& at, bool next_button) {
    if (next_button) return next_pair_screen(fonts, at);
    const auto [next, count, practice] = at;
    std::optional<Event> event;
    const Grid grid = grid_for(count);
    const auto columns = static_cast<float>(grid.columns);
    const auto body = [&] {
        head(fonts, at);
        const float space = ImGui::GetStyle().ItemSpacing.x;
        const float room = ImGui::GetContentRegionAvail().x;
        const float width = std::floor((room - space * (columns - 1.0F)) / columns);
        SideBySide row(space);
        for (int pair = 0; pair < count; ++pair) {
            row.next(width);
            if (pair_button(pair, next, grid, width)) event = PairPressed{pair};
        }
    };
    const auto foot = [&] {
        if (enter_pressed()) event = PairPressed{next};
        hint(fonts,
             words()("done", {{"done", std::to_string(next)}, {"count", std::to_string(count)}}));
    };
    card("##pairs", std::max(24.0F, 4.0F + columns * (grid.column + 0.6F)), body, foot);
    return event;
}

}  // namespace obscura::app::kiosk
