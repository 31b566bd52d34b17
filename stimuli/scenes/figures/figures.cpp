// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iterator>
#include <memory>
#include <vector>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/list.h"
#include "stimuli/scenes/support/texture_maker.h"

namespace obscura::stimuli {
namespace {

const glm::vec3 kTowardsSun = glm::normalize(glm::vec3(0.55F, 0.75F, 0.65F));

Placed turned(const glm::vec3& origin_m, float turn_rad) {
    return {origin_m, axes_from(glm::vec3(std::sin(turn_rad), 0.0F, std::cos(turn_rad)),
                                glm::vec3(0.0F, 1.0F, 0.0F))};
}

renderer::Scene build() {
    // All at once, so that no core waits while one of them is begun or put together.
    renderer::Scene man;
    renderer::Scene woman;
    renderer::Scene scene;
    for_each_row(3, [&](int which) {
        if (which == 0) {
            figures::add_to_scene(man, figures::make_man(turned({-0.36F, 0.0F, 0.0F}, 0.18F)));
        } else if (which == 1) {
            figures::add_to_scene(woman, figures::make_woman(turned({0.36F, 0.0F, 0.06F}, -0.20F)));
        } else {
            figures::add_materials(scene);
            figures::add_surroundings(scene);
            figures::add_backdrop(scene);
        }
    });
    scene.name = "figures";
    for (renderer::Scene* person : {&woman, &man}) {
        scene.meshes.insert(scene.meshes.begin(), std::move_iterator(person->meshes.begin()),
                            std::move_iterator(person->meshes.end()));
    }
    const auto camera = [](const char* name, glm::vec3 from, glm::vec3 at, float fov_rad) {
        renderer::Camera result;
        result.name = name;
        result.position_m = from;
        result.target_m = at;
        result.vertical_fov_rad = fov_rad;
        result.near_m = 0.1F;
        result.far_m = 30.0F;
        return result;
    };
    scene.cameras = {camera("pair", {0.05F, 1.35F, 3.65F}, {0.0F, 0.895F, 0.0F}, 0.545F),
                     camera("close", {0.05F, 1.56F, 1.95F}, {0.0F, 1.42F, 0.0F}, 0.46F)};
    return scene;
}

renderer::Lighting lighting(Validity validity) {
    renderer::Lighting result;
    renderer::SkyColours sky;
    sky.towards_sun = kTowardsSun;
    // Nothing of the sky is in view: it is as bright as white things before it can bear.
    sky.zenith = {0.92F, 1.06F, 1.32F};
    sky.horizon = {1.62F, 1.58F, 1.48F};
    sky.ground = {0.66F, 0.59F, 0.49F};
    sky.cloud_cover = 0.6F;
    sky.seed = 7;
    result.environment = std::make_shared<renderer::Environment>(renderer::make_sky(sky, 512));
    if (validity == Validity::kHigh) {
        result.lights = {{kTowardsSun, glm::vec3(4.6F, 4.2F, 3.5F)}};
        result.normal_mapping = true;
        result.tone_mapping = renderer::ToneMapping{1.0F, 2.6F};
    }
    return result;
}

}  // namespace

BuiltinScene make_figures() {
    return {.id = "figures",
            .title = "A man and a woman, clothed, standing on worn stone before a house",
            .stands_in_for = "the two game characters",
            .levels = {Validity::kModerate, Validity::kHigh},
            .cameras = {"pair", "close"},
            .build = build,
            .lighting = lighting};
}

}  // namespace obscura::stimuli
