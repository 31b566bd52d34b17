// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <cstdlib>

#include "renderer/base/error.h"
#include "stimuli/study_text.h"
#include "stimuli/study_writer.h"
#include "stimuli/variant_format.h"

namespace obscura::stimuli {
namespace {

/// The shortest number that comes back as the same single-precision value.
std::string exact(float value) {
    std::string shortest = fmt::format("{}", value);
    if (shortest.find_first_of(".en") == std::string::npos) shortest += ".0";
    const bool same = static_cast<float>(std::strtod(shortest.c_str(), nullptr)) == value;
    return same ? shortest : toml_float(value);
}

std::string exact(const glm::vec3& v) {
    return fmt::format("[{}, {}, {}]", exact(v.x), exact(v.y), exact(v.z));
}

/// Degrees that become these radians again, to the bit where some do.
float degrees_of(float radians) {
    const float nearest = glm::degrees(radians);
    float above = nearest;
    float below = nearest;
    for (int i = 0; i < 8; ++i) {
        if (glm::radians(above) == radians) return above;
        if (glm::radians(below) == radians) return below;
        above = std::nextafter(above, 1e9F);
        below = std::nextafter(below, 0.0F);
    }
    return nearest;
}

std::string camera_text(const renderer::Camera& camera) {
    return fmt::format(
        "{{ position_m = {}, target_m = {}, vertical_fov_deg = {}, near_m = {}, far_m = {} }}",
        exact(camera.position_m), exact(camera.target_m),
        exact(degrees_of(camera.vertical_fov_rad)), exact(camera.near_m), exact(camera.far_m));
}

/// Strength as colour and irradiance whose product is exact: a power of two loses no bit.
std::string strength_text(const glm::vec3& strength) {
    const float most = std::max({strength.x, strength.y, strength.z});
    const float irradiance = most > 0.0F ? std::exp2(std::ceil(std::log2(most))) : 0.0F;
    const glm::vec3 colour = irradiance > 0.0F ? strength / irradiance : glm::vec3(1.0F);
    return fmt::format("colour = {}\nirradiance = {}\n", exact(colour), exact(irradiance));
}

std::string lights_text(const SceneSettings& settings) {
    std::string text;
    for (const renderer::DirectionalLight& light : settings.lights) {
        text += fmt::format("\n[[scene.light]]\ndirection = {}\n{}", exact(-light.towards_light),
                            strength_text(light.irradiance));
    }
    for (const renderer::PointLight& light : settings.point_lights) {
        text += fmt::format("\n[[scene.light]]\nposition_m = {}\n{}", exact(light.position_m),
                            strength_text(light.intensity));
        if (std::isfinite(light.range_m))
            text += fmt::format("range_m = {}\n", exact(light.range_m));
        if (light.outer_cone_rad < glm::pi<float>()) {
            text += fmt::format("direction = {}\ncone_deg = {}\n", exact(light.direction),
                                exact(degrees_of(light.outer_cone_rad)));
        }
    }
    return text;
}

/// Begins a table behind the text.
std::string begun(std::string_view text) {
    std::string begun(text);
    if (!begun.empty() && begun.back() != '\n') begun += '\n';
    return begun + '\n';
}

}  // namespace

std::string with_scene(std::string_view text, const StudyScene& scene) {
    const SceneSettings& settings = scene.settings;
    std::string table = "[[scene]]\n";
    table += fmt::format("id = {}\nsource = {}\n", quoted(scene.id), quoted(scene.source));
    table += fmt::format("camera = {}\n",
                         settings.camera ? camera_text(*settings.camera) : quoted(scene.camera));
    table += fmt::format("validity = \"{}\"\n", to_string(scene.validity));
    if (settings.scale != 1.0) table += fmt::format("scale = {}\n", toml_float(settings.scale));
    if (!settings.environment.empty()) {
        table += fmt::format("environment = {}\n", quoted(settings.environment.generic_string()));
    }
    if (settings.irradiance_probes) {
        table += fmt::format("irradiance_probes = {}\n", *settings.irradiance_probes);
    }
    if (settings.exposure) table += fmt::format("exposure = {}\n", exact(*settings.exposure));
    if (settings.white) table += fmt::format("white = {}\n", exact(*settings.white));
    if (settings.tone_curve) {
        table += fmt::format("tone_mapping = \"{}\"\n", to_string(*settings.tone_curve));
    }
    if (settings.ambient) table += fmt::format("ambient = {}\n", exact(*settings.ambient));
    return begun(text) + table + lights_text(settings);
}

std::string with_condition(std::string_view text, const Condition& condition) {
    return begun(text) + fmt::format("[[condition]]\nid = {}\nscene = {}\na = {}\nb = {}\n",
                                     quoted(condition.id), quoted(condition.scene),
                                     to_toml(condition.a), to_toml(condition.b));
}

}  // namespace obscura::stimuli
