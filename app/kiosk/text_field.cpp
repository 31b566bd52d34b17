// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <set>

// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/kiosk/set_text.h"
#include "app/kiosk/widgets.h"

namespace obscura::app::kiosk {
namespace {

constexpr char32_t kBox = U'\u25A1';

[[nodiscard]] Typesetter& typesetter() { return *page_state().tools.typesetter; }

/// The first `count` characters as they are shown: those without a glyph as a box, hidden ones as
/// dots.
[[nodiscard]] std::string shown_text(const TextEntry& entry, std::size_t count) {
    if (entry.hidden()) {
        std::string dots;
        for (std::size_t i = 0; i < std::min(count, entry.text().size()); ++i) dots += "\u2022";
        return dots;
    }
    const std::set<char32_t> missing = typesetter().characters_without_glyph(entry.utf8());
    std::string shown;
    for (const char32_t character : entry.text().substr(0, count)) {
        shown += utf8_of(missing.contains(character) ? kBox : character);
    }
    return shown;
}

/// The place between characters nearest to there, from the text's left.
[[nodiscard]] std::size_t caret_at(const TextEntry& entry, float x_px) {
    const std::string shown = shown_text(entry, entry.text().size());
    const std::size_t byte = typesetter().byte_at(shown, ImGui::GetFontSize(), x_px);
    const auto begins_character = [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    };
    return static_cast<std::size_t>(std::count_if(
        shown.begin(), shown.begin() + static_cast<std::ptrdiff_t>(byte), begins_character));
}

void edit(TextEntry& entry, const Stroke& stroke) {
    if (stroke.character != 0) {
        entry.type(stroke.character);
        return;
    }
    switch (stroke.key) {
        case GLFW_KEY_BACKSPACE:
            entry.erase_before();
            break;
        case GLFW_KEY_DELETE:
            entry.erase_after();
            break;
        case GLFW_KEY_LEFT:
            entry.move(-1);
            break;
        case GLFW_KEY_RIGHT:
            entry.move(1);
            break;
        case GLFW_KEY_HOME:
            entry.move_to(0);
            break;
        case GLFW_KEY_END:
            entry.move_to(entry.text().size());
            break;
        default:
            break;
    }
}

/// Where the text begins so that its caret is in the field; both from the field's inner left.
[[nodiscard]] float left_of_text(float text_px, float caret_px, float room_px) {
    const float left = is_mirrored() ? room_px - text_px : 0.0F;
    if (left + caret_px > room_px) return room_px - caret_px;
    return left + caret_px < 0.0F ? -caret_px : left;
}

}  // namespace

bool has_boxes(const TextEntry& entry) {
    return !typesetter().characters_without_glyph(entry.utf8()).empty();
}

void text_field(const char* name, TextEntry& entry, float width_px) {
    const ImGuiID id = ImGui::GetID(name);
    const bool here = begin_stop(id, StopKind::kText);
    const float text_px = ImGui::GetFontSize();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const float room = width_px - 2.0F * padding.x;
    ImGui::InvisibleButton(name, {width_px, ImGui::GetFrameHeight()});
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    if (here) {
        for (const Stroke& stroke : page_state().input.strokes) edit(entry, stroke);
    }
    const std::string shown = shown_text(entry, entry.text().size());
    const auto caret_px = [&] {
        return typesetter().caret_px(shown, text_px, shown_text(entry, entry.caret()).size());
    };
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
    const SetText& text = typesetter().set(shown, {.text_px = text_px, .colour = ink});
    const float left = left_of_text(text.width_px, caret_px(), room);
    if (ImGui::IsItemActivated()) {
        // Who types on a keyboard and only points with the mouse has no use for keys.
        PageState& page = page_state();
        if (page.keypad.field != id && (here || !page.keyboard_types)) page.keypad = {.field = id};
        entry.move_to(caret_at(entry, ImGui::GetIO().MousePos.x - from.x - padding.x - left));
    }
    (void)end_stop(id, here);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
    list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_Border), rounding);
    list.PushClipRect({from.x + 0.5F * padding.x, from.y}, {to.x - 0.5F * padding.x, to.y}, true);
    const float text_left = std::round(from.x + padding.x + left);
    const float line_top = std::round(0.5F * (from.y + to.y - text.height_px));
    draw_text(text, {text_left, line_top});
    if (here) {
        const float caret = std::round(from.x + padding.x + left + caret_px());
        const float top = from.y + padding.y;
        list.AddRectFilled({caret, top}, {caret + std::max(1.0F, 0.08F * text_px), top + text_px},
                           ink);
    }
    list.PopClipRect();
}

}  // namespace obscura::app::kiosk
