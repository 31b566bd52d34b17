// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/explorer/fields.h"
#include "app/explorer/flight.h"
#include "stimuli/scenes/builtin_scene.h"

namespace obscura::app::explorer {
namespace {

void source_menu(Desk& desk) {
    std::vector<std::string> ids;
    std::vector<std::string> titles;
    for (const stimuli::BuiltinScene& scene : stimuli::builtin_scenes()) {
        ids.push_back(scene.id);
        titles.push_back(scene.title);
    }
    const std::string now = desk.model.choices().scene.source;
    const auto chosen =
        choice_field(desk, "scene", "Built-in scenes; Ctrl+O opens a file", ids, now, titles);
    if (chosen) desk.orders.open = *chosen;
}

/// Whether the view and the pair are the condition's.
[[nodiscard]] bool is_seen(const Model& model, const stimuli::Condition& condition) {
    const Choices& choices = model.choices();
    if (!(condition.a == choices.a) || !(condition.b == choices.b)) return false;
    const stimuli::StudyScene& scene = model.study()->study.scene_of(condition);
    if (scene.source != choices.scene.source || scene.validity != choices.scene.validity) {
        return false;
    }
    return scene.settings.camera ? same_view(*scene.settings.camera, model.view().camera)
                                 : scene.camera == model.view().name;
}

void condition_menu(Desk& desk) {
    if (!desk.model.study()) return;
    const stimuli::Study& study = desk.model.study()->study;
    std::vector<std::string> ids;
    std::vector<std::string> meanings;
    std::string now = "choose";
    for (const stimuli::Condition& condition : study.conditions) {
        if (is_seen(desk.model, condition)) now = condition.id;
        ids.push_back(condition.id);
        meanings.push_back(fmt::format("{}: {} against {}", condition.scene,
                                       condition.a.variant_name(), condition.b.variant_name()));
    }
    const auto chosen = choice_field(desk, "condition", "Shows a pair of the study " + study.name,
                                     ids, now, meanings);
    if (chosen) desk.orders.condition = *chosen;
}

void camera_field(Desk& desk) {
    if (!desk.model.scene()) return;
    std::vector<std::string> names;
    std::string now = "own view";
    for (const Model::NamedCamera& one : desk.model.cameras()) {
        names.push_back(one.name);
        if (same_view(one.camera, desk.model.view().camera)) now = one.name;
    }
    const auto chosen =
        choice_field(desk, "camera", "The scene's own cameras and the study's", names, now);
    if (chosen) desk.model.look_from(*chosen, desk.now_s);
}

void level_menu(Desk& desk) {
    if (!desk.model.scene()) return;
    const Choices& choices = desk.model.choices();
    std::vector<std::string> names;
    for (const stimuli::Validity level :
         stimuli::levels_with(desk.model.scene()->opened().levels, choices.scene.settings)) {
        names.emplace_back(to_string(level));
    }
    const auto chosen = choice_field(
        desk, "validity",
        "Of the light: low is ambient only, moderate an environment, high that and lights with "
        "shadows",
        names, std::string(to_string(choices.scene.validity)));
    if (!chosen) return;
    desk.model.change([&](Choices& to) { to.scene.validity = *stimuli::validity_from(*chosen); },
                      "", desk.now_s);
}

void exposure_field(Desk& desk) {
    NumberField field{"exposure",
                      "Factor of the light before the tone curve; 0 is the scene's own.",
                      "",
                      0.0,
                      16.0,
                      0.0,
                      false,
                      desk.model.choices().scene.settings.exposure.value_or(0.0F),
                      "the scene's own"};
    if (const auto value = number_field(desk, field)) {
        desk.model.change(
            [&](Choices& to) {
                to.scene.settings.exposure.reset();
                if (*value > 0.0) to.scene.settings.exposure = static_cast<float>(*value);
            },
            "exposure", desk.now_s);
    }
}

/// A file of light from all round; empty: the scene's own.
void environment_field(Desk& desk) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("environment");
    tooltip(
        "A Radiance HDR or OpenEXR file, for the levels moderate and high; empty: the scene's own");
    ImGui::TableNextColumn();
    std::string& path = desk.state.environment;
    if (!text_field("##environment", path, -1.0F)) return;
    try {
        if (!path.empty()) (void)renderer::load_environment(path);
    } catch (const std::exception& error) {
        desk.say(error.what(), true);
        return;
    }
    const std::string whole = path.empty() ? "" : std::filesystem::absolute(path).string();
    desk.model.change([&](Choices& to) { to.scene.settings.environment = whole; }, "", desk.now_s);
}

void size_fields(Desk& desk) {
    const Choices& choices = desk.model.choices();
    static const std::vector<std::string> kSizes{"640x360",   "960x540",   "1280x720",
                                                 "1920x1080", "2560x1440", "3840x2160"};
    const auto size =
        choice_field(desk, "image size", "In pixels; the window shows it larger or smaller", kSizes,
                     fmt::format("{}x{}", choices.width, choices.height));
    if (size) {
        const std::size_t cross = size->find('x');
        desk.model.change(
            [&](Choices& to) {
                to.width = std::stoi(size->substr(0, cross));
                to.height = std::stoi(size->substr(cross + 1));
            },
            "", desk.now_s);
    }
    NumberField field{
        "supersampling",
        "Samples of surfaces and light along each side of a pixel, once it stands still.",
        "",
        1.0,
        static_cast<double>(renderer::kMostSupersampling),
        1.0,
        true,
        static_cast<double>(choices.supersampling)};
    if (const auto value = number_field(desk, field)) {
        desk.model.change([&](Choices& to) { to.supersampling = static_cast<int>(*value); },
                          "supersampling", desk.now_s);
    }
}

void camera_fields(Desk& desk) {
    const renderer::Camera& camera = desk.model.view().camera;
    NumberField fov{"field of view", "Vertical.", "deg", 1.0,
                    170.0,           45.0,        false, glm::degrees(camera.vertical_fov_rad)};
    if (const auto value = number_field(desk, fov)) {
        desk.model.look_from(with_fov(upright(camera), static_cast<float>(*value)), desk.now_s);
    }
    NumberField speed{"speed", "Of flying; the wheel over the image changes it.",
                      "m/s",   0.001,
                      1000.0,  1.0,
                      false,   desk.state.speed_m_s};
    if (desk.model.scene()) speed.standard = usual_speed_m_s(desk.model.scene()->bounds());
    speed.standard = std::clamp(speed.standard, speed.low, speed.high);
    if (const auto value = number_field(desk, speed)) {
        desk.state.speed_m_s = static_cast<float>(*value);
    }
}

}  // namespace

void scene_panel(Desk& desk) {
    desk.state.panel = "scene";
    if (begin_fields("scene")) {
        source_menu(desk);
        condition_menu(desk);
        camera_field(desk);
        level_menu(desk);
        environment_field(desk);
        exposure_field(desk);
        size_fields(desk);
        camera_fields(desk);
        end_fields();
    }
    if (!desk.model.scene()) return;
    for (const std::string& note : desk.model.scene()->opened().notes) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(note.c_str());
        ImGui::PopTextWrapPos();
    }
}

}  // namespace obscura::app::explorer
