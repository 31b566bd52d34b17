// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/scene_settings.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace obscura::stimuli {
namespace {

using Json = nlohmann::ordered_json;

Json to_array(const glm::vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::string to_json(const SceneSettings& settings) {
    Json json = Json::object();
    if (settings.scale != 1.0) json["scale"] = settings.scale;
    if (settings.camera) {
        const renderer::Camera& camera = *settings.camera;
        json["camera"] = {{"position_m", to_array(camera.position_m)},
                          {"target_m", to_array(camera.target_m)},
                          {"vertical_fov_rad", camera.vertical_fov_rad},
                          {"near_m", camera.near_m},
                          {"far_m", camera.far_m}};
    }
    if (!settings.environment.empty()) json["environment"] = settings.environment.string();
    if (settings.irradiance_probes) json["irradiance_probes"] = *settings.irradiance_probes;
    if (settings.exposure) json["exposure"] = *settings.exposure;
    if (settings.white) json["white"] = *settings.white;
    if (settings.tone_curve) json["tone_mapping"] = to_string(*settings.tone_curve);
    if (settings.ambient) json["ambient"] = to_array(*settings.ambient);
    for (const renderer::DirectionalLight& light : settings.lights) {
        json["lights"].push_back({{"towards_light", to_array(light.towards_light)},
                                  {"irradiance", to_array(light.irradiance)}});
    }
    for (const renderer::PointLight& light : settings.point_lights) {
        Json entry = {{"position_m", to_array(light.position_m)},
                      {"intensity", to_array(light.intensity)},
                      {"direction", to_array(light.direction)},
                      {"inner_cone_rad", light.inner_cone_rad},
                      {"outer_cone_rad", light.outer_cone_rad}};
        if (std::isfinite(light.range_m)) entry["range_m"] = light.range_m;
        json["lights"].push_back(entry);
    }
    return json.dump();
}

}  // namespace obscura::stimuli
