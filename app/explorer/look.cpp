// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/look.h"

#include <imgui.h>

#include <cmath>

#include "app/window/theme.h"

namespace obscura::app::explorer {

void set_look(float text_px) {
    using namespace window::theme;
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsLight(&style);
    style.WindowPadding = {std::round(text_px * 0.6F), std::round(text_px * 0.5F)};
    style.FramePadding = {std::round(text_px * 0.4F), std::round(text_px * 0.2F)};
    style.ItemSpacing = {std::round(text_px * 0.5F), std::round(text_px * 0.35F)};
    style.ItemInnerSpacing = {std::round(text_px * 0.35F), std::round(text_px * 0.25F)};
    style.ScrollbarSize = std::round(text_px * 0.8F);
    style.GrabMinSize = std::round(text_px * 0.7F);
    style.FrameBorderSize = 1.0F;
    style.WindowBorderSize = 1.0F;
    style.FrameRounding = text_px * 0.2F;
    style.PopupRounding = text_px * 0.2F;
    style.WindowMinSize = {1.0F, 1.0F};
    ImVec4* colours = style.Colors;
    colours[ImGuiCol_WindowBg] = kCard;
    colours[ImGuiCol_PopupBg] = kFieldHovered;
    colours[ImGuiCol_MenuBarBg] = kQuiet;
    colours[ImGuiCol_Text] = kInk;
    colours[ImGuiCol_TextDisabled] = kFaintInk;
    colours[ImGuiCol_Border] = kLine;
    colours[ImGuiCol_FrameBg] = kField;
    colours[ImGuiCol_FrameBgHovered] = kFieldHovered;
    colours[ImGuiCol_FrameBgActive] = kFieldHovered;
    colours[ImGuiCol_CheckMark] = kAccent;
    // The number is read through it.
    colours[ImGuiCol_SliderGrab] = {kAccent.x, kAccent.y, kAccent.z, 0.35F};
    colours[ImGuiCol_SliderGrabActive] = {kAccent.x, kAccent.y, kAccent.z, 0.5F};
    colours[ImGuiCol_Button] = kQuiet;
    colours[ImGuiCol_ButtonHovered] = kQuietHovered;
    colours[ImGuiCol_ButtonActive] = kQuietPressed;
    colours[ImGuiCol_Header] = kQuiet;
    colours[ImGuiCol_HeaderHovered] = kQuietHovered;
    colours[ImGuiCol_HeaderActive] = kQuietPressed;
    colours[ImGuiCol_Tab] = kQuiet;
    colours[ImGuiCol_TabHovered] = kFieldHovered;
    colours[ImGuiCol_TabActive] = kField;
    colours[ImGuiCol_PlotLines] = kAccent;
    colours[ImGuiCol_PlotHistogram] = kAccent;
    colours[ImGuiCol_NavHighlight] = kAccent;
    colours[ImGuiCol_TextSelectedBg] = {kAccent.x, kAccent.y, kAccent.z, 0.3F};
    colours[ImGuiCol_ModalWindowDimBg] = {0.1F, 0.1F, 0.1F, 0.5F};
}

}  // namespace obscura::app::explorer
