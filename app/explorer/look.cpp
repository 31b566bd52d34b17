// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/look.h"

#include <imgui.h>

#include <cmath>

#include "app/window/theme.h"

namespace obscura::app::explorer {

void set_look(float text_px) {
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
    window::theme::set_colours(style);
}

}  // namespace obscura::app::explorer
