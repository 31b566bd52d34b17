// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <glm/gtc/constants.hpp>
#include <memory>

#include "stimuli/scenes/atrium/parts.h"
#include "stimuli/scenes/list.h"

namespace obscura::stimuli {
namespace {

using glm::vec3;

renderer::Camera camera(std::string name, vec3 position_m, vec3 target_m, float vertical_fov_deg) {
    renderer::Camera view;
    view.name = std::move(name);
    view.position_m = position_m;
    view.target_m = target_m;
    view.vertical_fov_rad = glm::radians(vertical_fov_deg);
    view.near_m = 0.1F;
    view.far_m = 60.0F;
    return view;
}

renderer::Scene build() {
    atrium::Site site;
    atrium::build_arcades(site);
    atrium::build_galleries(site);
    atrium::build_shell(site);
    atrium::build_walls(site);
    atrium::build_relief(site);
    atrium::build_cloth(site);
    atrium::build_furnishings(site);
    atrium::weather(site);
    renderer::Scene scene = site.take();
    scene.name = "atrium";
    scene.cameras.push_back(camera("nave", {-1.5F, 1.8F, 10.3F}, {0.45F, 3.1F, 0.0F}, 58.0F));
    scene.cameras.push_back(camera("gallery", {5.6F, 7.3F, 6.55F}, {-2.6F, 5.4F, -1.25F}, 58.0F));
    scene.cameras.push_back(camera("corner", {0.3F, 1.7F, 6.6F}, {3.7F, 1.75F, 2.2F}, 54.0F));
    return scene;
}

renderer::Lighting lighting(Validity validity) {
    // Across the court from the left, steep enough to reach the floor and one arcade.
    const vec3 towards_sun = glm::normalize(vec3(-0.36F, 1.0F, 0.2F));
    renderer::SkyColours sky;
    sky.zenith = {0.70F, 0.95F, 1.47F};
    sky.horizon = {0.87F, 0.88F, 0.92F};
    sky.ground = {0.56F, 0.46F, 0.35F};  // sunlit stone below
    sky.sun_glow = {2.1F, 1.75F, 1.26F};
    sky.towards_sun = towards_sun;
    sky.cloud_cover = 0.5F;
    sky.seed = 3;
    renderer::Lighting light;
    light.environment = std::make_shared<renderer::Environment>(renderer::make_sky(sky));
    // A court sees a quarter of the sky and its arcades less: as bright as the eye gets used to.
    light.irradiance_probes = true;
    light.tone_mapping = renderer::ToneMapping{4.7F, 6.0F};
    if (validity == Validity::kHigh) {
        renderer::DirectionalLight sun;
        sun.towards_light = towards_sun;
        sun.irradiance = vec3(1.0F, 0.92F, 0.78F) * 13.0F;
        light.lights.push_back(sun);
        light.normal_mapping = true;
        light.tone_mapping = renderer::ToneMapping{2.0F, 6.5F};
    }
    return light;
}

}  // namespace

BuiltinScene make_atrium() {
    BuiltinScene scene;
    scene.id = "atrium";
    scene.title = "A two-storey arcaded court with curtains, planters and a carved lion's mask";
    scene.stands_in_for = "the Sponza atrium of Crytek";
    scene.levels = {Validity::kModerate, Validity::kHigh};
    scene.cameras = {"nave", "gallery", "corner"};
    scene.build = build;
    scene.lighting = lighting;
    return scene;
}

}  // namespace obscura::stimuli
