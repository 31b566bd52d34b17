// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include "stimuli/scenes/list.h"
#include "stimuli/scenes/machine/parts.h"

namespace obscura::stimuli {
namespace {

using glm::vec3;

renderer::Scene build() {
    Assembly hall("machine", machine::finishes());
    machine::build_cylinder(hall);
    machine::build_engine(hall);
    machine::build_gears(hall);
    machine::build_generator(hall);
    machine::build_cooler(hall);
    machine::build_hall(hall);
    machine::build_clutter(hall);
    renderer::Scene scene = hall.take();
    scene.cameras = {
        camera_at("engine", {1.75F, 1.62F, 3.05F}, {0.02F, 0.72F, -0.1F}, 44.0F, 20.0F),
        camera_at("gears", {1.72F, 1.25F, 1.72F}, {0.78F, 0.76F, 0.2F}, 46.0F, 20.0F),
        camera_at("cylinder", {-1.9F, 1.5F, 1.55F}, {-0.78F, 0.82F, 0.0F}, 48.0F, 20.0F)};
    return scene;
}

/// What a machine in the middle of the hall sees: high windows to the left of the wall, a row of
/// lamps above, dim brick and a grey floor.
glm::vec3 hall_radiance(const vec3& way) {
    const vec3 brick(0.46F, 0.42F, 0.37F);
    const vec3 floor(0.30F, 0.29F, 0.27F);
    vec3 light = glm::mix(floor, brick, glm::smoothstep(-0.25F, 0.15F, way.y));
    const float turn = std::atan2(way.x, way.z);  // 0 is towards the viewer
    // Tall windows behind the viewer and to the left, the sky's light through them.
    const float side = glm::smoothstep(1.9F, 0.4F, std::abs(turn + 0.5F));
    const float high = glm::smoothstep(0.05F, 0.25F, way.y) * glm::smoothstep(0.95F, 0.7F, way.y);
    light += vec3(2.1F, 2.25F, 2.45F) * side * high;
    light += vec3(1.7F, 1.6F, 1.4F) * glm::smoothstep(0.75F, 0.95F, way.y);
    return light;
}

renderer::Lighting lighting(Validity validity) {
    renderer::Lighting light;
    if (validity == Validity::kLow) return light;
    auto surroundings = std::make_shared<renderer::Environment>();
    surroundings->name = "engine hall";
    surroundings->width = 128;
    surroundings->height = 64;
    for (int row = 0; row < surroundings->height; ++row) {
        for (int column = 0; column < surroundings->width; ++column) {
            surroundings->radiance.push_back(
                1.4F * hall_radiance(renderer::direction_of_texel(*surroundings, column, row)));
        }
    }
    light.environment = std::move(surroundings);
    light.irradiance_probes = true;
    light.tone_mapping = renderer::ToneMapping{1.5F, 4.0F};
    if (validity == Validity::kHigh) {
        light.lights = {
            {glm::normalize(vec3(-0.42F, 0.52F, 0.74F)), vec3(1.0F, 0.93F, 0.80F) * 9.0F}};
        light.normal_mapping = true;
        light.tone_mapping = renderer::ToneMapping{0.85F, 4.0F};
    }
    return light;
}

}  // namespace

BuiltinScene make_machine() {
    return {.id = "machine",
            .title = "A stationary engine that drives a generator through gears, in its hall",
            .stands_in_for = "",
            .levels = {Validity::kLow, Validity::kModerate, Validity::kHigh},
            .cameras = {"engine", "gears", "cylinder"},
            .build = build,
            .lighting = lighting};
}

}  // namespace obscura::stimuli
