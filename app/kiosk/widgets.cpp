// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "app/kiosk/set_text.h"
#include "app/window/theme.h"

namespace obscura::app::kiosk {
namespace {

using namespace window::theme;

/// Added to the text's height: space between lines, and for an empty line.
constexpr float kLeading = 0.32F;
constexpr float kParagraphGap = 0.25F;

/// In the font and colour of the moment; 0 wide: on one line.
[[nodiscard]] const SetText& set_text(const std::string& text, float width_px = 0.0F,
                                      bool centred = false) {
    return page_state().tools.typesetter->set(text, {.text_px = ImGui::GetFontSize(),
                                                     .width_px = std::floor(width_px),
                                                     .between_lines_px = times_text(kLeading),
                                                     .colour = ImGui::GetColorU32(ImGuiCol_Text),
                                                     .centred = centred});
}

/// A text as wide as the card, as an item of Dear ImGui.
void put_lines(const std::string& text) {
    const float width_px = ImGui::GetContentRegionAvail().x;
    const SetText& set = set_text(text, width_px);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(set, {at.x + set.left_px, at.y});
    ImGui::Dummy({width_px, set.height_px});
}

}  // namespace

void draw_text(const SetText& text, ImVec2 at) {
    for (const TextTile& tile : text.tiles) {
        const ImVec2 from{std::round(at.x) + tile.left_px, std::round(at.y) + tile.top_px};
        ImGui::GetWindowDrawList()->AddImage(
            reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(tile.texture)), from,
            {from.x + tile.width_px, from.y + tile.height_px});
    }
}

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
    style.ScrollbarSize = text_px * 1.1F;  // wide enough for a finger
    style.DisabledAlpha = 1.0F;            // fading would make text too faint to read
    set_colours(style);
}

void heading(const Fonts& fonts, const std::string& text) {
    ImGui::PushFont(fonts.heading);
    put_lines(text);
    ImGui::PopFont();
    gap(0.4F);
}

void paragraph(const std::string& text) {
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, times_text(kLeading)});
    std::string_view left = text;
    while (!left.empty()) {
        const auto end = left.find('\n');
        const std::string_view line = left.substr(0, end);
        if (line.empty()) {
            ImGui::Dummy({1.0F, times_text(kParagraphGap)});
        } else {
            put_lines(std::string(line));
        }
        left.remove_prefix(end == std::string_view::npos ? left.size() : end + 1);
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

float text_width(const std::string& text) { return set_text(text).width_px; }

SideBySide::SideBySide(float apart_px)
    : apart_px_(apart_px),
      left_px_(ImGui::GetCursorPosX()),
      room_px_(ImGui::GetContentRegionAvail().x) {}

void SideBySide::next(float width_px) {
    if (!first_ && used_px_ + width_px <= room_px_) {
        ImGui::SameLine();
    } else {
        used_px_ = 0.0F;
    }
    first_ = false;
    const float off_px = is_mirrored() ? room_px_ - used_px_ - width_px : used_px_;
    ImGui::SetCursorPosX(left_px_ + std::round(off_px));
    used_px_ += width_px + apart_px_;
}

namespace {

[[nodiscard]] bool button(const std::string& label, float width_px, float height, StopKind kind,
                          bool is_stop = true) {
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
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const SetText& text = set_text(label, width_px - 2.0F * padding.x, true);
    const float height_px =
        std::max(times_text(height), std::ceil(text.height_px) + 2.0F * padding.y);
    ImGui::PushID(label.c_str());
    const ImGuiID id = ImGui::GetID("##button");
    const bool here = is_stop && begin_stop(id, kind);
    const bool clicked = ImGui::Button("##button", {width_px, height_px});
    const ImVec2 from = ImGui::GetItemRectMin();
    draw_text(text,
              {from.x + padding.x + text.left_px, from.y + 0.5F * (height_px - text.height_px)});
    const bool pressed = is_stop && end_stop(id, here);
    ImGui::PopID();
    ImGui::PopStyleColor(colours);
    return clicked || pressed;
}

[[nodiscard]] bool centred_button(const std::string& label, float around, StopKind kind) {
    const float room = ImGui::GetContentRegionAvail().x;
    const float width =
        std::min(room, std::ceil(text_width(label)) + around * ImGui::GetFontSize());
    ImGui::SetCursorPosX(std::round((ImGui::GetWindowWidth() - width) * 0.5F));
    return button(label, width, 2.1F, kind);
}

/// Side of what is ticked or chosen, and the space to its label.
[[nodiscard]] float mark_px() { return times_text(1.24F); }
[[nodiscard]] float mark_gap_px() { return ImGui::GetStyle().ItemInnerSpacing.x; }

/// A mark with its label; `draw_mark` gets the mark's upper left corner and colour behind it.
template <typename DrawMark>
[[nodiscard]] bool choice(const std::string& label, float text_px, const DrawMark& draw_mark) {
    const SetText& text = set_text(label, text_px);
    const float side = mark_px();
    const float height = std::max(side, std::ceil(text.height_px));
    const float width = side + mark_gap_px() + text_px;
    ImGui::PushID(label.c_str());
    const ImGuiID id = ImGui::GetID("##choice");
    const bool here = begin_stop(id);
    const bool clicked = ImGui::InvisibleButton("##choice", {width, height});
    const ImVec2 from = ImGui::GetItemRectMin();
    const bool right = is_mirrored();
    draw_mark(
        ImVec2{right ? from.x + width - side : from.x, from.y},
        ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg));
    const float line_px = std::min(text.height_px, side);
    draw_text(text, {from.x + (right ? 0.0F : side + mark_gap_px()) + text.left_px,
                     from.y + 0.5F * (side - line_px)});
    const bool pressed = end_stop(id, here);
    ImGui::PopID();
    return clicked || pressed;
}

}  // namespace

bool wide_button(const std::string& label, float width_px, float height, bool primary) {
    return button(label, width_px, height, primary ? StopKind::kPrimary : StopKind::kPlain);
}

bool primary_button(const std::string& label) {
    const bool pressed = centred_button(label, 6.0F, StopKind::kPrimary);
    return pressed || enter_pressed();
}

bool quiet_button(const std::string& label) {
    return centred_button(label, 4.0F, StopKind::kPlain);
}

bool pad_button(const std::string& label, float width_px) {
    return button(label, width_px, 0.0F, StopKind::kPlain, false);
}

bool radio(SideBySide& row, const std::string& label, bool chosen) {
    const float text_px = std::ceil(text_width(label));
    const float room = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    const float label_px = std::min(text_px, room - mark_px() - mark_gap_px());
    row.next(mark_px() + mark_gap_px() + label_px);
    return choice(label, label_px, [&](ImVec2 at, ImU32 behind) {
        const float radius = 0.5F * (mark_px() - 1.0F);
        const ImVec2 centre{at.x + 0.5F * mark_px(), at.y + 0.5F * mark_px()};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddCircleFilled(centre, radius, behind);
        list.AddCircle(centre, radius, ImGui::GetColorU32(ImGuiCol_Border));
        if (!chosen) return;
        const float inner = radius - std::max(1.0F, std::floor(mark_px() / 6.0F));
        list.AddCircleFilled(centre, inner, ImGui::GetColorU32(ImGuiCol_CheckMark));
    });
}

void tick(const std::string& label, bool& ticked) {
    const float room = ImGui::GetContentRegionAvail().x;
    const float label_px = std::min(std::ceil(text_width(label)), room - mark_px() - mark_gap_px());
    SideBySide row(0.0F);
    row.next(mark_px() + mark_gap_px() + label_px);
    const bool shown = ticked;
    const bool pressed = choice(label, label_px, [&](ImVec2 at, ImU32 behind) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 to{at.x + mark_px(), at.y + mark_px()};
        const float rounding = ImGui::GetStyle().FrameRounding;
        list.AddRectFilled(at, to, behind, rounding);
        list.AddRect(at, to, ImGui::GetColorU32(ImGuiCol_Border), rounding);
        if (!shown) return;
        const float pad = std::max(1.0F, std::floor(mark_px() / 6.0F));
        ImGui::RenderCheckMark(&list, {at.x + pad, at.y + pad},
                               ImGui::GetColorU32(ImGuiCol_CheckMark), mark_px() - 2.0F * pad);
    });
    if (pressed) ticked = !ticked;
}

std::string marked_required(const std::string& label) {
    // The star stays with the last word.
    return label.ends_with('*') ? label : label + "\u00A0*";
}

void row_text(SideBySide& row, const std::string& text) {
    const SetText& set = set_text(text);
    row.next(set.width_px);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(set, {at.x, at.y + 0.5F * (ImGui::GetFrameHeight() - set.height_px)});
    ImGui::Dummy({set.width_px, ImGui::GetFrameHeight()});
}

void yes_no(const char* name, const std::string& question, std::optional<bool>& answer) {
    ImGui::PushID(name);
    paragraph(question);
    SideBySide row(ImGui::GetFontSize() * 1.6F);
    if (radio(row, words()("yes"), answer == true)) answer = true;
    if (radio(row, words()("no"), answer == false)) answer = false;
    ImGui::PopID();
}

}  // namespace obscura::app::kiosk
