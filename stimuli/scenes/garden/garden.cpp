// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include "stimuli/scenes/garden/parts.h"
#include "stimuli/scenes/list.h"

namespace obscura::stimuli {
namespace {

using glm::vec3;

const vec3 kTowardsSun = glm::normalize(vec3(0.62F, 0.72F, 0.46F));

renderer::Scene build() {
    Assembly garden("garden", garden::finishes());
    garden::build_walls(garden);
    garden::build_ground(garden);
    garden::build_climbers(garden);
    garden::build_border(garden);
    garden::build_ornaments(garden);
    renderer::Scene scene = garden.take();
    scene.cameras = {
        camera_at("bench", {1.35F, 1.55F, 3.55F}, {-0.25F, 0.80F, -1.3F}, 46.0F, 30.0F),
        camera_at("urn", {0.35F, 1.45F, 1.35F}, {-2.15F, 0.88F, -1.75F}, 48.0F, 30.0F),
        camera_at("border", {2.9F, 1.25F, 0.65F}, {0.95F, 0.45F, -2.1F}, 46.0F, 30.0F)};
    return scene;
}

renderer::Lighting lighting(Validity validity) {
    renderer::SkyColours sky;
    sky.towards_sun = kTowardsSun;
    // What is seen of it stays below white, where no tone curve is; the rest is the bright part
    // behind the viewer.
    sky.zenith = {0.44F, 0.58F, 0.86F};
    sky.horizon = {0.66F, 0.70F, 0.76F};
    sky.ground = {0.46F, 0.44F, 0.34F};
    sky.sun_glow = {2.9F, 2.65F, 2.15F};
    sky.cloud_cover = 0.45F;
    sky.seed = 11;
    renderer::Lighting light;
    light.environment = std::make_shared<renderer::Environment>(renderer::make_sky(sky));
    if (validity == Validity::kHigh) {
        light.lights = {{kTowardsSun, vec3(1.0F, 0.92F, 0.78F) * 5.2F}};
        light.normal_mapping = true;
        light.tone_mapping = renderer::ToneMapping{1.2F, 4.0F};
    }
    return light;
}

}  // namespace

BuiltinScene make_garden() {
    return {.id = "garden",
            .title =
                "A walled garden: ivy, ferns and shrubs, a stone bench and an urn by a gravel path",
            .stands_in_for = "",
            .levels = {Validity::kModerate, Validity::kHigh},
            .cameras = {"bench", "urn", "border"},
            .build = build,
            .lighting = lighting};
}

}  // namespace obscura::stimuli
