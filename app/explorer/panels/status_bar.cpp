// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include "app/explorer/desk.h"
#include "app/explorer/fields.h"
#include "app/explorer/pixel_text.h"
#include "app/window/theme.h"

namespace obscura::app::explorer {
namespace {

/// What is seen and how good it is.
[[nodiscard]] std::string state_of(const Desk& desk) {
    const Model& model = desk.model;
    const Choices& choices = model.choices();
    if (!model.scene()) return desk.opening.empty() ? "no scene" : "opening " + desk.opening;
    std::string size = fmt::format("{}x{}", choices.width, choices.height);
    const auto shown = model.image(model.layout().ever_visible().front().side);
    if (shown && shown->look == model.look() && shown->quality != Quality::kMoving) {
        size += shown->supersampling > 1 ? fmt::format(", {0}x{0} samples", shown->supersampling)
                                         : ", full size";
    } else if (model.divisor() > 1) {
        size += fmt::format(", drawn at 1/{} size while it moves", model.divisor());
    } else {
        size += ", full size";
    }
    if (shown && shown->coarse) size += ", with fewer triangles";
    return fmt::format("{} {}, {}{}{}", choices.scene.source, to_string(choices.scene.validity),
                       size, desk.rendering ? ", rendering" : "",
                       desk.tracing ? ", tracing the truth" : "");
}

}  // namespace

void status_bar(Desk& desk, float height_px) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0F, screen.y - height_px});
    ImGui::SetNextWindowSize({screen.x, height_px});
    ImGui::Begin("##status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(state_of(desk).c_str());
    const std::string pixel =
        desk.state.pointer_px ? pixel_text(desk.model, *desk.state.pointer_px) : "";
    ImGui::TextUnformatted(pixel.empty() ? "Point at the image for its values. F1 lists the keys."
                                         : pixel.c_str());
    if (!desk.state.messages.empty()) {
        const Message& last = desk.state.messages.back();
        if (last.problem) ImGui::PushStyleColor(ImGuiCol_Text, window::theme::kComplaint);
        std::string line = last.text;
        for (char& c : line) {
            if (c == '\n') c = ' ';
        }
        ImGui::TextUnformatted(line.c_str());
        tooltip(last.text);
        if (last.problem) ImGui::PopStyleColor();
    }
    ImGui::End();
}

}  // namespace obscura::app::explorer
