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

#include "app/kiosk/letters.h"
#include "app/kiosk/theme.h"

namespace obscura::app::kiosk {
namespace {

using namespace theme;

/// Added to the text's height: space between lines, and for an empty line.
constexpr float kLeading = 0.32F;
constexpr float kParagraphGap = 0.25F;

/// Free space between a card and the window's edge, in pixels.
constexpr float kMargin_px = 24.0F;

}  // namespace

void set_style(float text_px) {
    ImGuiStyle& style = ImGui::GetStyle();
    ImGui::StyleColorsLight(&style);
    style.WindowPadding = {text_px * 2.0F, text_px * 1.7F};
    style.WindowRounding = text_px * 0.5F;
    style.WindowBorderSize = 0.0F;
    style.FramePadding = {text_px * 0.6F, text_px * 0.38F};
    style.FrameRounding = text_px * 0.25F;
    style.FrameBorderSize = 1.0F;
    style.ItemSpacing = {text_px * 0.6F, text_px * 0.55F};
    style.ItemInnerSpacing = {text_px * 0.45F, text_px * 0.3F};
    style.ScrollbarSize = text_px * 0.7F;
    style.DisabledAlpha = 0.45F;
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

void card(const char* name, float columns, const std::function<void()>& content,
          Keyboard keyboard) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float room = screen.x - 2.0F * kMargin_px;
    const float width = std::round(std::min(room, columns * ImGui::GetFontSize()));
    ImGui::SetNextWindowPos({screen.x * 0.5F, screen.y * 0.5F}, ImGuiCond_Always, {0.5F, 0.5F});
    const float tallest = screen.y - 2.0F * kMargin_px;
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, tallest});
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                             ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                             ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize;
    // Rounding alone must not bring a scroll bar.
    const ImGuiWindow* before = ImGui::FindWindowByName(name);
    const float padding = 2.0F * ImGui::GetStyle().WindowPadding.y;
    if (before == nullptr || before->ContentSize.y + padding <= tallest) {
        flags |= ImGuiWindowFlags_NoScrollbar;
    }
    if (keyboard == Keyboard::kIsLeftToTheCaller) flags |= ImGuiWindowFlags_NoNav;
    if (ImGui::Begin(name, nullptr, flags)) {
        if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
        content();
    }
    ImGui::End();
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
    const float size = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, size * kLeading});
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    while (at < end) {
        const char* line_end = std::find(at, end, '\n');
        if (line_end == at) {
            ImGui::Dummy({1.0F, size * kParagraphGap});
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

void gap(float lines) { ImGui::Dummy({1.0F, ImGui::GetFontSize() * lines}); }

bool enter_pressed() {
    return ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) ||
           ImGui::IsKeyPressed(GLFW_KEY_KP_ENTER, false);
}

bool letter_pressed(char letter) { return ImGui::IsKeyPressed(key_of_letter(letter), false); }

bool wide_button(const char* label, float width_px, float height, bool primary) {
    if (primary) {
        ImGui::PushStyleColor(ImGuiCol_Button, kAccent);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, kAccentHovered);
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, kAccentPressed);
        ImGui::PushStyleColor(ImGuiCol_Text, kOnAccent);
        ImGui::PushStyleColor(ImGuiCol_Border, kAccentPressed);
    }
    const bool pressed = ImGui::Button(label, {width_px, height * ImGui::GetFontSize()});
    if (primary) ImGui::PopStyleColor(5);
    return pressed;
}

bool primary_button(const char* label) {
    const float width = ImGui::CalcTextSize(label).x + 6.0F * ImGui::GetFontSize();
    ImGui::SetCursorPosX((ImGui::GetWindowWidth() - width) * 0.5F);
    const bool pressed = wide_button(label, width, 2.1F, true);
    ImGui::SetItemDefaultFocus();
    return pressed || enter_pressed();
}

bool quiet_button(const char* label) {
    const float width = ImGui::CalcTextSize(label).x + 4.0F * ImGui::GetFontSize();
    ImGui::SetCursorPosX((ImGui::GetWindowWidth() - width) * 0.5F);
    return wide_button(label, width, 2.1F, false);
}

bool radio(const char* label, bool chosen) {
    const float text_px = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {text_px * 0.2F, text_px * 0.12F});
    const bool pressed = ImGui::RadioButton(label, chosen);
    ImGui::PopStyleVar();
    return pressed;
}

void tick(const char* label, bool& ticked) {
    const float text_px = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {text_px * 0.2F, text_px * 0.12F});
    ImGui::Checkbox(label, &ticked);
    ImGui::PopStyleVar();
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
