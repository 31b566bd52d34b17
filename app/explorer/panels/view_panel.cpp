// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/explorer/fields.h"
#include "app/explorer/picture.h"

namespace obscura::app::explorer {
namespace {

/// The layers that there are, the technique's own buffers of that side last.
[[nodiscard]] std::vector<std::string> layers_of(const Model& model, char side) {
    std::vector<std::string> layers(layer::kAll.begin(), layer::kAll.end());
    if (const auto shot = model.buffers(side)) {
        for (const OwnBuffer& own : shot->own) layers.push_back(layer::kOwn + own.name);
    }
    return layers;
}

void pane_menus(Desk& desk, Layout& layout) {
    const std::size_t count = layout.arrangement == Arrangement::kFour ? layout.panes.size() : 1;
    const bool chooses_side =
        layout.arrangement == Arrangement::kOne || layout.arrangement == Arrangement::kFour;
    for (std::size_t i = 0; i < count; ++i) {
        Pane& pane = layout.panes[i];
        const std::string which = count > 1 ? fmt::format(" {}", i + 1) : "";
        const std::vector<std::string> layers = layers_of(desk.model, pane.side);
        std::vector<std::string> meanings;
        for (const std::string& one : layers) meanings.push_back(layer::meaning_of(one));
        const auto chosen = choice_field(desk, "shows" + which, layer::meaning_of(pane.layer),
                                         layers, pane.layer, meanings);
        if (chosen) pane.layer = *chosen;
        if (!chooses_side) continue;
        const auto side =
            choice_field(desk, "of" + which, "", {"A", "B"}, pane.side == 'a' ? "A" : "B");
        if (side) pane.side = *side == "A" ? 'a' : 'b';
    }
}

void scale_fields(Desk& desk, Layout& layout) {
    const auto shows = [&](const char* wanted) {
        const auto panes = layout.ever_visible();
        return std::any_of(panes.begin(), panes.end(),
                           [&](const Pane& pane) { return pane.layer == wanted; });
    };
    if (shows(layer::kError)) {
        NumberField field{
            "error range",     "Where the error's colours end.", "", 0.01, 1.0, 0.25, false,
            layout.error_range};
        if (const auto value = number_field(desk, field)) {
            layout.error_range = static_cast<float>(*value);
        }
    }
    if (shows(layer::kDepth)) {
        NumberField low{
            "depth from",      "Where the depth's colours begin.", "m", 0.0, 1000.0, 0.0, false,
            layout.depth_low_m};
        if (const auto value = number_field(desk, low)) {
            layout.depth_low_m = static_cast<float>(*value);
        }
        NumberField high{"depth to", "Where they end; 0: what is seen decides.",
                         "m",        0.0,
                         1000.0,     0.0,
                         false,      layout.depth_high_m,
                         "as seen"};
        if (const auto value = number_field(desk, high)) {
            layout.depth_high_m = static_cast<float>(*value);
        }
    }
    if (layout.arrangement == Arrangement::kFlicker) {
        NumberField rate{"flicker",
                         "Changes a second between A and B.",
                         "Hz",
                         0.1,
                         kMostFlicker_hz,
                         1.0,
                         false,
                         layout.flicker_hz};
        if (const auto value = number_field(desk, rate)) layout.flicker_hz = *value;
    }
}

}  // namespace

void view_panel(Desk& desk) {
    desk.state.panel = "view";
    Layout layout = desk.model.layout();
    for (const Arrangement arrangement : kArrangements) {
        if (arrangement != kArrangements.front()) ImGui::SameLine();
        if (ImGui::RadioButton(to_string(arrangement), layout.arrangement == arrangement)) {
            layout.arrangement = arrangement;
        }
    }
    if (begin_fields("view")) {
        pane_menus(desk, layout);
        scale_fields(desk, layout);
        end_fields();
    }
    if (!(layout == desk.model.layout())) desk.model.set_layout(layout, desk.now_s);
}

}  // namespace obscura::app::explorer
