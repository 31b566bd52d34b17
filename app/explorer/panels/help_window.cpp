// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <imgui.h>

#include "app/explorer/desk.h"
#include "app/explorer/keys.h"

namespace obscura::app::explorer {

void help_window(Desk& desk) {
    if (!desk.state.help) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({0.0F, 0.9F * screen.y}, ImGuiCond_Appearing);
    if (ImGui::Begin("Keys", &desk.state.help,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
            const auto row = [](const std::string& name, const std::string& does) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(name.c_str());
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(does.c_str());
            };
            for (const Motion& motion : motions()) row(motion.name, motion.does);
            for (const Key& key : keys()) row(key.name, key.does);
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

}  // namespace obscura::app::explorer
