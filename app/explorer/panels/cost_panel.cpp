// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "app/explorer/cost_text.h"
#include "app/explorer/fields.h"
#include "renderer/frame/explain.h"

namespace obscura::app::explorer {
namespace {

void passes(const Desk& desk, char side) {
    const auto costs = desk.model.costs(side);
    double sum = 0.0;
    if (ImGui::BeginTable("passes", 3, ImGuiTableFlags_RowBg)) {
        ImGui::TableSetupColumn("pass");
        ImGui::TableSetupColumn("median");
        ImGui::TableSetupColumn("so far");
        for (const Model::PassCost& cost : costs) {
            sum += cost.median_ms;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(cost.name.c_str());
            ImGui::TableNextColumn();
            ImGui::Text("%.2f ms", cost.median_ms);
            tooltip(fmt::format("of {} images", cost.history_ms.size()));
            ImGui::TableNextColumn();
            ImGui::PlotLines(
                "##history", cost.history_ms.data(), static_cast<int>(cost.history_ms.size()), 0,
                nullptr, 0.0F, FLT_MAX,
                {std::max(1.0F, ImGui::GetContentRegionAvail().x), ImGui::GetFontSize()});
        }
        ImGui::EndTable();
    }
    ImGui::Text("in all %.2f ms", sum);
}

void buffers(const Shot& shot) {
    if (!ImGui::BeginTable("buffers", 3, ImGuiTableFlags_RowBg)) return;
    for (const renderer::PlannedTarget& target : shot.buffers_planned) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(target.name.c_str());
        tooltip(renderer::form_of(target));
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(target.format.c_str());
        ImGui::TableNextColumn();
        ImGui::Text("%.2f MB", static_cast<double>(target.bytes) / 1e6);
    }
    ImGui::EndTable();
}

void of_side(Desk& desk, char side) {
    const auto shot = desk.model.buffers(side);
    ImGui::PushID(side);
    const std::string title = fmt::format("{}: {}", side == 'a' ? 'A' : 'B',
                                          desk.model.choices().side(side).variant_name());
    ImGui::TextUnformatted(title.c_str());
    passes(desk, side);
    if (shot) {
        ImGui::Text("%d fetches a pixel, buffers %.1f MB", shot->fetches,
                    static_cast<double>(shot->bytes) / 1e6);
        if (ImGui::TreeNode("buffers")) {
            buffers(*shot);
            ImGui::TreePop();
        }
        if (ImGui::TreeNode("left out")) {
            ImGui::PushTextWrapPos(0.0F);
            for (const renderer::LeftOut& one : shot->left_out) {
                ImGui::TextUnformatted(fmt::format("{}: {}", one.what, one.why).c_str());
            }
            ImGui::PopTextWrapPos();
            ImGui::TreePop();
        }
    }
    ImGui::PopID();
    ImGui::Separator();
}

}  // namespace

void cost_panel(Desk& desk) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(desk.device.c_str());
    ImGui::PopTextWrapPos();
    of_side(desk, 'a');
    of_side(desk, 'b');
    constexpr int kTimes = 9;
    if (ImGui::Button("Time again (T)")) desk.model.time_again(kTimes);
    tooltip(fmt::format("Renders both images {} times more while nothing is traced", kTimes));
    ImGui::SameLine();
    if (ImGui::Button("Copy as text (Ctrl+C)"))
        desk.orders.copy = cost_text(desk.model, desk.device);
    if (desk.model.timings_left() > 0) ImGui::Text("%d to go", desk.model.timings_left());
}

}  // namespace obscura::app::explorer
