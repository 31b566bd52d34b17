// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <utility>

#include "app/explorer/fields.h"

namespace obscura::app::explorer {

void open_window(Desk& desk) {
    if (!desk.opening.empty()) {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        ImGui::SetNextWindowPos({0.5F * screen.x, 0.4F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
        ImGui::Begin("##opening", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
        ImGui::TextUnformatted(
            fmt::format("Opening {} ... {:.1f} s", desk.opening, desk.opening_s).c_str());
        if (ImGui::Button("Cancel (Escape)")) desk.orders.cancel_opening = true;
        ImGui::End();
    }
    constexpr const char* kName = "Open a scene or study";
    if (std::exchange(desk.state.open_dialog, false)) ImGui::OpenPopup(kName);
    const float width = std::min(40.0F * ImGui::GetFontSize(), 0.9F * ImGui::GetIO().DisplaySize.x);
    ImGui::SetNextWindowSize({width, 0.0F});
    if (!ImGui::BeginPopupModal(kName, nullptr, ImGuiWindowFlags_NoSavedSettings)) return;
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(
        "A .gltf, .glb or .obj file, a study file (.toml), or the name of a built-in scene or "
        "study. Files can be dropped on the window, too.");
    ImGui::PopTextWrapPos();
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool entered = text_field("##path", desk.state.open_path, -1.0F);
    const bool pressed = ImGui::Button("Open (Enter)");
    if ((entered || pressed) && !desk.state.open_path.empty()) {
        desk.orders.open = desk.state.open_path;
        ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (ImGui::Button("Cancel (Escape)") || escape_pressed()) {
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace obscura::app::explorer
