// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include "stimuli/scenes/list.h"
#include "stimuli/scenes/room/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli {
namespace {

using glm::vec3;

renderer::Scene build() {
    Assembly study("room", room::finishes());
    room::build_shell(study);
    room::build_fabrics(study);
    room::build_furniture(study);
    room::build_books(study);
    room::build_desk_things(study);
    room::build_clutter(study);
    renderer::Scene scene = study.take();
    scene.cameras = {
        camera_at("desk", {1.05F, 1.56F, 1.75F}, {-0.72F, 0.86F, -1.35F}, 50.0F, 20.0F),
        camera_at("shelves", {-0.95F, 1.50F, 0.95F}, {0.85F, 1.0F, -1.85F}, 50.0F, 20.0F),
        camera_at("tabletop", {0.22F, 1.34F, -0.55F}, {-0.98F, 0.80F, -1.66F}, 44.0F, 20.0F)};
    return scene;
}

/// Outside the window: a pale sky over trees.
vec3 outdoors(const vec3& way) {
    const float turn = std::atan2(way.z, -way.x);
    const float crown = 0.10F + 0.16F * fbm(glm::vec2(turn * 5.0F, 0.5F), 61, 4);
    const float leaves = fbm(glm::vec2(turn * 22.0F, way.y * 26.0F), 62, 4);
    const vec3 sky = glm::mix(vec3(2.3F, 2.35F, 2.4F), vec3(1.6F, 1.9F, 2.4F),
                              glm::clamp(1.4F * way.y, 0.0F, 1.0F));
    const vec3 tree = vec3(0.33F, 0.40F, 0.23F) * (1.0F + 0.9F * leaves);
    const float covered = glm::smoothstep(0.03F, -0.03F, way.y - crown - 0.05F * leaves);
    return glm::mix(sky, glm::max(tree, vec3(0.05F)), covered);
}

/// Beyond the window; below, the light that a lawn sends up.
vec3 radiance_of(const vec3& way) {
    constexpr float kOfDay = 3.0F;  // with the sun's at the level high
    const vec3 lawn(0.52F, 0.50F, 0.40F);
    return kOfDay * glm::mix(lawn, outdoors(way), glm::smoothstep(-0.35F, -0.1F, way.y));
}

renderer::Lighting lighting(Validity validity) {
    auto surroundings = std::make_shared<renderer::Environment>();
    surroundings->name = "study";
    surroundings->width = 1024;
    surroundings->height = 512;
    surroundings->radiance.resize(1024 * 512);
    for_each_row(512, [&](int row) {
        for (int column = 0; column < 1024; ++column) {
            surroundings->radiance[static_cast<std::size_t>(row * 1024 + column)] =
                radiance_of(renderer::direction_of_texel(*surroundings, column, row));
        }
    });
    renderer::Lighting light;
    light.environment = std::move(surroundings);
    // What comes through the window, and from there off walls and floor.
    light.irradiance_probes = true;
    light.tone_mapping = renderer::ToneMapping{10.5F, 8.0F};
    if (validity == Validity::kHigh) {
        light.lights = {
            {glm::normalize(vec3(-0.80F, 0.60F, 0.20F)), vec3(1.0F, 0.90F, 0.74F) * 7.5F}};
        renderer::PointLight lamp;
        // Just below the bulb, whose own mesh would shade it.
        lamp.position_m = room::lamp_bulb_m() + 0.045F * room::lamp_axis();
        lamp.intensity = vec3(1.0F, 0.74F, 0.44F) * 0.9F;
        lamp.direction = room::lamp_axis();
        lamp.inner_cone_rad = 0.65F;
        lamp.outer_cone_rad = 1.15F;
        light.point_lights = {lamp};
        light.normal_mapping = true;
        light.tone_mapping = renderer::ToneMapping{8.0F, 8.0F};
    }
    return light;
}

}  // namespace

BuiltinScene make_room() {
    return {.id = "room",
            .title = "A study with a desk, an armchair and shelves full of books by a window",
            .stands_in_for = "",
            .levels = {Validity::kModerate, Validity::kHigh},
            .cameras = {"desk", "shelves", "tabletop"},
            .build = build,
            .lighting = lighting};
}

}  // namespace obscura::stimuli
