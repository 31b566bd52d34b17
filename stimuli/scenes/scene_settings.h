// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"

namespace obscura::stimuli {

/// What a study says of a scene beyond its source, camera and level. What is not said is the
/// scene's own.
struct SceneSettings {
    double scale = 1.0;  ///< metres of one unit of a file; built-in scenes are in metres
    std::optional<renderer::Camera> camera;  ///< a view of the study's own
    std::filesystem::path environment;       ///< Radiance HDR or OpenEXR; empty: none given
    /// Whether the environment's irradiance depends on where one stands.
    std::optional<bool> irradiance_probes;
    std::optional<float> exposure;  ///< > 0
    std::optional<float> white;     ///< > 0
    std::optional<renderer::ToneCurve> tone_curve;
    std::optional<glm::vec3> ambient;  ///< radiance, >= 0
    std::vector<renderer::DirectionalLight> lights;
    std::vector<renderer::PointLight> point_lights;

    /// Whether the study gives lights of its own, in place of the scene's.
    [[nodiscard]] bool has_lights() const { return !lights.empty() || !point_lights.empty(); }
};

/// The settings as one line of JSON, what is not said left out: equal text, equal settings.
[[nodiscard]] std::string to_json(const SceneSettings& settings);

}  // namespace obscura::stimuli
