// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/window/theme.h"

namespace obscura::app::kiosk {
namespace {

using namespace window::theme;

/// Added to the text's height: space between lines, and for an empty line.
constexpr float kLeading = 0.32F;
constexpr float kParagraphGap = 0.25F;

}  // namespace

void set_style(float text_px) {
    ImGuiStyle& style = ImGui::GetStyle();
    ImGui::StyleColorsLight(&style);
    style.WindowPadding = {std::round(text_px * 2.0F), std::round(text_px * 1.7F)};
    style.WindowRounding = text_px * 0.5F;
    style.WindowBorderSize = 0.0F;
    style.FramePadding = {std::round(text_px * 0.6F), std::round(text_px * 0.38F)};
    style.FrameRounding = text_px * 0.25F;
    style.FrameBorderSize = 1.0F;
    style.ItemSpacing = {std::round(text_px * 0.6F), std::round(text_px * 0.55F)};
    style.ItemInnerSpacing = {std::round(text_px * 0.45F), std::round(text_px * 0.3F)};
    style.ScrollbarSize = text_px * 0.7F;
    style.DisabledAlpha = 1.0F;  // fading would make text too faint to read
    ImVec4* colours = style.Colors;
    colours[ImGuiCol_WindowBg] = kCard;
    colours[ImGuiCol_Text] = kInk;
    colours[ImGuiCol_TextDisabled] = kFaintInk;
    colours[ImGuiCol_Border] = kLine;
    colours[ImGuiCol_FrameBg] = kField;
    colours[ImGuiCol_FrameBgHovered] = kFieldHovered;
    colours[ImGuiCol_FrameBgActive] = kFieldHovered;
    colours[ImGuiCol_CheckMark] = kAccent;
    colours[ImGuiCol_Button] = kQuiet;
    colours[ImGuiCol_ButtonHovered] = kQuietHovered;
    colours[ImGuiCol_ButtonActive] = kQuietPressed;
    colours[ImGuiCol_NavHighlight] = kAccent;
    colours[ImGuiCol_TextSelectedBg] = {kAccent.x, kAccent.y, kAccent.z, 0.3F};
}

void heading(const Fonts& fonts, const std::string& text) {
    ImGui::PushFont(fonts.heading);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    gap(0.4F);
}

void paragraph(const std::string& text) {
    ImGui::BeginGroup();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, times_text(kLeading)});
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    while (at < end) {
        const char* line_end = std::find(at, end, '\n');
        if (line_end == at) {
            ImGui::Dummy({1.0F, times_text(kParagraphGap)});
            ++at;
            continue;
        }
        while (at < line_end) {
            const char* wrap = ImGui::GetFont()->CalcWordWrapPositionA(1.0F, at, line_end, width);
            wrap = std::max(wrap, at + 1);
            ImGui::TextUnformatted(at, wrap);
            at = std::find_if(wrap, line_end, [](char c) { return c != ' '; });
        }
        if (at < end) ++at;  // the line's end
    }
    ImGui::PopStyleVar();
    ImGui::EndGroup();
}

void hint(const Fonts& fonts, const std::string& text) {
    ImGui::PushFont(fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, kFaintInk);
    paragraph(text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void complaint(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, kComplaint);
    paragraph(text);
    ImGui::PopStyleColor();
}

void gap(float lines) { ImGui::Dummy({1.0F, times_text(lines)}); }

namespace {

[[nodiscard]] bool button(const char* label, float width_px, float height, StopKind kind) {
    int colours = 0;
    const auto colour = [&colours](ImGuiCol which, const ImVec4& value) {
        ImGui::PushStyleColor(which, value);
        ++colours;
    };
    if (is_disabled()) {
        colour(ImGuiCol_Button, kCard);
        colour(ImGuiCol_Text, kFaintInk);
    } else if (kind == StopKind::kPrimary) {
        colour(ImGuiCol_Button, kAccent);
        colour(ImGuiCol_ButtonHovered, kAccentHovered);
        colour(ImGuiCol_ButtonActive, kAccentPressed);
        colour(ImGuiCol_Text, kOnAccent);
        colour(ImGuiCol_Border, kAccentPressed);
    }
    const ImGuiID id = ImGui::GetID(label);
    const bool here = begin_stop(id, kind);
    const bool clicked = ImGui::Button(label, {width_px, times_text(height)});
    const bool pressed = end_stop(id, here);
    ImGui::PopStyleColor(colours);
    return clicked || pressed;
}

/// A radio button or tick box, which are of one size.
template <typename Draw>
[[nodiscard]] bool choice(const char* label, const Draw& draw) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {times_text(0.2F), times_text(0.12F)});
    const ImGuiID id = ImGui::GetID(label);
    const bool here = begin_stop(id);
    const bool clicked = draw();
    const bool pressed = end_stop(id, here);
    ImGui::PopStyleVar();
    return clicked || pressed;
}

}  // namespace

bool wide_button(const char* label, float width_px, float height, bool primary) {
    return button(label, width_px, height, primary ? StopKind::kPrimary : StopKind::kPlain);
}

bool primary_button(const char* label) {
    const float width = ImGui::CalcTextSize(label).x + 6.0F * ImGui::GetFontSize();
    ImGui::SetCursorPosX((ImGui::GetWindowWidth() - width) * 0.5F);
    const bool pressed = button(label, width, 2.1F, StopKind::kPrimary);
    return pressed || enter_pressed();
}

bool quiet_button(const char* label) {
    const float width = ImGui::CalcTextSize(label).x + 4.0F * ImGui::GetFontSize();
    ImGui::SetCursorPosX((ImGui::GetWindowWidth() - width) * 0.5F);
    return wide_button(label, width, 2.1F, false);
}

bool radio(const char* label, bool chosen) {
    return choice(label, [&] { return ImGui::RadioButton(label, chosen); });
}

void tick(const char* label, bool& ticked) {
    bool shown = ticked;
    if (choice(label, [&] { return ImGui::Checkbox(label, &shown); })) ticked = !ticked;
}

namespace {

constexpr char32_t kBox = U'\u25A1';

[[nodiscard]] bool is_drawn(char32_t character) {
    return character <= 0xFFFF &&
           ImGui::GetFont()->FindGlyphNoFallback(static_cast<ImWchar>(character)) != nullptr;
}

/// The first `count` characters as they are shown.
[[nodiscard]] std::string shown_text(const TextEntry& entry, std::size_t count) {
    std::string shown;
    for (const char32_t character : entry.text().substr(0, count)) {
        shown += utf8_of(is_drawn(character) ? character : kBox);
    }
    return shown;
}

[[nodiscard]] float shown_width(const TextEntry& entry, std::size_t count) {
    const std::string shown = shown_text(entry, count);
    return ImGui::CalcTextSize(shown.data(), shown.data() + shown.size()).x;
}

/// The place between characters nearest to there.
[[nodiscard]] std::size_t caret_at(const TextEntry& entry, float x_px) {
    std::size_t best = 0;
    for (std::size_t at = 1; at <= entry.text().size(); ++at) {
        if (std::abs(shown_width(entry, at) - x_px) < std::abs(shown_width(entry, best) - x_px)) {
            best = at;
        }
    }
    return best;
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

}  // namespace

bool has_boxes(const TextEntry& entry) {
    return !std::all_of(entry.text().begin(), entry.text().end(), is_drawn);
}

void text_field(const char* name, TextEntry& entry, float width_px) {
    const ImGuiID id = ImGui::GetID(name);
    const bool here = begin_stop(id, StopKind::kText);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float text_px = ImGui::GetFontSize();
    const float padding = ImGui::GetStyle().FramePadding.x;
    const float room = width_px - 2.0F * padding;
    ImGui::InvisibleButton(name, {width_px, ImGui::GetFrameHeight()});
    const ImVec2 to = ImGui::GetItemRectMax();
    if (here) {
        for (const Stroke& stroke : page_state().input.strokes) edit(entry, stroke);
    }
    // A text longer than its field shows the part where the caret is.
    const float off = std::max(0.0F, shown_width(entry, entry.caret()) - room);
    if (ImGui::IsItemActivated()) {
        entry.move_to(caret_at(entry, ImGui::GetIO().MousePos.x - from.x - padding + off));
    }
    (void)end_stop(id, here);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
    list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_Border), rounding);
    list.PushClipRect({from.x + 0.5F * padding, from.y}, {to.x - 0.5F * padding, to.y}, true);
    const std::string shown = shown_text(entry, entry.text().size());
    const float left = from.x + padding - off;
    const float top = from.y + ImGui::GetStyle().FramePadding.y;
    list.AddText({left, top}, ImGui::GetColorU32(ImGuiCol_Text), shown.data(),
                 shown.data() + shown.size());
    if (here) {
        const float caret = std::round(left + shown_width(entry, entry.caret()));
        list.AddRectFilled({caret, top}, {caret + std::max(1.0F, 0.08F * text_px), top + text_px},
                           ImGui::GetColorU32(ImGuiCol_Text));
    }
    list.PopClipRect();
}

void yes_no(const char* name, const std::string& question, std::optional<bool>& answer) {
    ImGui::PushID(name);
    paragraph(question);
    if (radio("Yes", answer == true)) answer = true;
    ImGui::SameLine(0.0F, ImGui::GetFontSize() * 1.6F);
    if (radio("No", answer == false)) answer = false;
    ImGui::PopID();
}

}  // namespace obscura::app::kiosk
