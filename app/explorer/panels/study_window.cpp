// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <utility>

#include "app/explorer/fields.h"
#include "app/explorer/study_entry.h"
#include "app/window/theme.h"

namespace obscura::app::explorer {
namespace {

constexpr const char* kName = "Save into a study";

void prepare(Desk& desk) {
    StudyDialog& dialog = desk.state.study_dialog;
    const auto& study = desk.model.study();
    dialog.problem.clear();
    dialog.takes_changed_file = false;
    if (dialog.file.empty()) dialog.file = study ? study->file.string() : "";
    const std::string stem = std::filesystem::path(desk.model.choices().scene.id).stem().string();
    dialog.scene_id = free_scene_id(study, stem.empty() ? "view" : stem);
    dialog.condition_id = free_condition_id(study);
}

void labelled(const char* label, std::string& text, bool& entered) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::TableNextColumn();
    entered |= text_field(fmt::format("##{}", label).c_str(), text, -1.0F);
}

}  // namespace

void study_window(Desk& desk) {
    StudyDialog& dialog = desk.state.study_dialog;
    if (std::exchange(desk.state.study_dialog_open, false)) {
        prepare(desk);
        ImGui::OpenPopup(kName);
    }
    const float width =
        std::min(44.0F * ImGui::GetFontSize(), 0.95F * ImGui::GetIO().DisplaySize.x);
    ImGui::SetNextWindowSize({width, 0.0F});
    if (!ImGui::BeginPopupModal(kName, nullptr, ImGuiWindowFlags_NoSavedSettings)) return;
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(
        "Adds the view as a scene, and A and B as a condition. Everything else in the file, "
        "comments too, stays as it is; the file is checked before it is replaced.");
    ImGui::PopTextWrapPos();
    bool entered = false;
    if (begin_fields("entry")) {
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        labelled("study file (.toml)", dialog.file, entered);
        labelled("scene's id", dialog.scene_id, entered);
        if (!dialog.camera_only) labelled("condition's id", dialog.condition_id, entered);
        end_fields();
    }
    ImGui::Checkbox("the view alone, without a condition", &dialog.camera_only);
    if (!dialog.camera_only) {
        ImGui::Checkbox("replace A and B of a condition that is there", &dialog.replaces);
    }
    ImGui::Checkbox("take a file that is there, or was changed meanwhile, as it is now",
                    &dialog.takes_changed_file);
    if (!dialog.problem.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, window::theme::kComplaint);
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(dialog.problem.c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopStyleColor();
    }
    if (ImGui::Button("Save (Enter)") || entered) desk.orders.save_to_study = true;
    ImGui::SameLine();
    const bool escaped = escape_pressed() && !ImGui::IsAnyItemActive();
    if (ImGui::Button("Cancel") || escaped || dialog.done) ImGui::CloseCurrentPopup();
    dialog.done = false;
    ImGui::EndPopup();
}

}  // namespace obscura::app::explorer
