// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/window/theme.h"

namespace obscura::app::window::theme {

void set_colours(ImGuiStyle& style) {
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

}  // namespace obscura::app::window::theme
