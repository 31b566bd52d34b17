// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include "app/explorer/desk.h"
#include "app/explorer/flight.h"
#include "app/explorer/keys.h"
#include "stimuli/scenes/builtin_scene.h"

namespace obscura::app::explorer {
namespace {

/// A menu's line with the key that does the same.
[[nodiscard]] bool line(const char* name, Deed deed, bool possible = true, bool ticked = false) {
    return ImGui::MenuItem(name, key_of(deed).c_str(), ticked, possible);
}

void file_menu(Desk& desk) {
    if (!ImGui::BeginMenu("File")) return;
    if (line("Open...", Deed::kOpen)) desk.state.open_dialog = true;
    if (ImGui::BeginMenu("Built-in scene")) {
        for (const stimuli::BuiltinScene& scene : stimuli::builtin_scenes()) {
            if (ImGui::MenuItem(scene.id.c_str(), scene.title.c_str())) desk.orders.open = scene.id;
        }
        ImGui::EndMenu();
    }
    ImGui::Separator();
    if (line("Save image (PNG)", Deed::kSaveImage)) desk.orders.save_image = true;
    if (line("Save buffers (EXR)", Deed::kSaveBuffers)) desk.orders.save_buffers = true;
    if (line("Save into a study...", Deed::kSaveToStudy)) desk.state.study_dialog_open = true;
    ImGui::Separator();
    if (line("Quit", Deed::kQuit)) desk.orders.close = true;
    ImGui::EndMenu();
}

void edit_menu(Desk& desk) {
    if (!ImGui::BeginMenu("Edit")) return;
    if (line("Undo", Deed::kUndo, desk.model.can_undo())) desk.model.undo(desk.now_s);
    if (line("Redo", Deed::kRedo, desk.model.can_redo())) desk.model.redo(desk.now_s);
    ImGui::EndMenu();
}

void camera_menu(Desk& desk) {
    if (!ImGui::BeginMenu("Camera")) return;
    Model& model = desk.model;
    if (line("Back", Deed::kBack, model.can_go_back())) model.back(desk.now_s);
    if (line("Forward", Deed::kForward, model.can_go_forward())) model.forward(desk.now_s);
    if (line("Frame all", Deed::kFrameAll, model.scene() != nullptr)) {
        model.look_from(framing(model.view().camera, model.scene()->bounds(), model.aspect()),
                        desk.now_s);
    }
    ImGui::Separator();
    for (const Model::NamedCamera& one : model.cameras()) {
        const bool here = same_view(one.camera, model.view().camera);
        if (ImGui::MenuItem(one.name.c_str(), nullptr, here)) model.look_from(one.name, desk.now_s);
    }
    ImGui::EndMenu();
}

void view_menu(Desk& desk) {
    if (!ImGui::BeginMenu("View")) return;
    Layout layout = desk.model.layout();
    for (const Arrangement one : kArrangements) {
        if (ImGui::MenuItem(to_string(one), nullptr, layout.arrangement == one)) {
            layout.arrangement = one;
        }
    }
    ImGui::Separator();
    Pane& pane = layout.panes[static_cast<std::size_t>(desk.state.active_pane)];
    int number = 1;
    for (const char* name : layer::kAll) {
        const std::string key = std::to_string(number++ % 10);
        if (ImGui::MenuItem(name, key.c_str(), pane.layer == name)) pane.layer = name;
    }
    ImGui::Separator();
    if (line("Zoom in", Deed::kZoomIn))
        layout.zoom = next_zoom(layout.zoom, true, desk.state.whole_zoom);
    if (line("Zoom out", Deed::kZoomOut))
        layout.zoom = next_zoom(layout.zoom, false, desk.state.whole_zoom);
    if (line("Panels", Deed::kPanels, true, desk.state.panels)) {
        desk.state.panels = !desk.state.panels;
    }
    if (line("Larger text", Deed::kLargerText)) desk.state.text_scale *= 1.1F;
    if (line("Smaller text", Deed::kSmallerText)) desk.state.text_scale /= 1.1F;
    if (!(layout == desk.model.layout())) desk.model.set_layout(layout, desk.now_s);
    ImGui::EndMenu();
}

}  // namespace

void menu_bar(Desk& desk) {
    if (!ImGui::BeginMainMenuBar()) return;
    file_menu(desk);
    edit_menu(desk);
    camera_menu(desk);
    view_menu(desk);
    if (ImGui::BeginMenu("Help")) {
        if (line("Keys", Deed::kHelp, true, desk.state.help)) desk.state.help = !desk.state.help;
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

}  // namespace obscura::app::explorer
