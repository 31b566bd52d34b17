// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/everything.h"

namespace obscura::renderer {

Lighting with_everything(const Lighting& lighting) {
    Lighting all = lighting;
    if (!all.environment) {
        auto constant = std::make_shared<Environment>();
        constant->name = "constant";
        constant->width = 64;
        constant->height = 32;
        constant->radiance.assign(64 * 32, lighting.ambient);
        all.environment = constant;
    }
    if (all.lights.empty()) all.lights.push_back({glm::vec3(0.0F, 1.0F, 0.0F), glm::vec3(0.0F)});
    if (!all.tone_mapping) all.tone_mapping = ToneMapping{1.0F, 1.0F, ToneCurve::kClip};
    return all;
}

SceneNeeds needs_of_everything(const Scene& scene, const Lighting& lighting) {
    SceneNeeds needs = needs_of(scene, lighting);
    needs.normal_mapping = lighting.normal_mapping;
    needs.textures = true;
    needs.specular = true;
    needs.roughness = true;
    needs.cut_out = true;
    needs.blended = true;
    needs.emission = true;
    return needs;
}

}  // namespace obscura::renderer
