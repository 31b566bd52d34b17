// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/plan.h"

#include <algorithm>

namespace obscura::renderer {

const PlannedTarget* FramePlan::find(std::string_view buffer) const {
    const auto found = std::find_if(targets.begin(), targets.end(), [buffer](const auto& planned) {
        return planned.name == buffer;
    });
    return found == targets.end() ? nullptr : &*found;
}

bool FramePlan::has(Phase phase) const {
    return std::any_of(passes.begin(), passes.end(),
                       [phase](const PlannedPass& planned) { return planned.phase == phase; });
}

std::size_t FramePlan::bytes() const {
    std::size_t sum = 0;
    for (const PlannedTarget& planned : targets) sum += planned.bytes;
    return sum;
}

bool FramePlan::makes_accessibility() const { return has(Phase::kTechnique) && !makes_colour; }

std::string FramePlan::final_accessibility() const {
    if (has(Phase::kUpsample)) return Target::kUpsampled.name;
    return (has(Phase::kDenoise) ? Target::kDenoised : Target::kAccessibility).name;
}

std::string FramePlan::accessibility_define() const {
    return "ACCESSIBILITY_COLUMNS " + std::to_string(find(final_accessibility())->columns);
}

bool FramePlan::blended_occlude() const {
    return technique_reads_depth && needs.blended && options.occluding_opacity.has_value();
}

std::string FramePlan::seen_by_technique(std::string_view buffer) const {
    if (has(Phase::kSeen)) {
        if (buffer == Target::kDepth.name) return Target::kSeenDepth.name;
        if (buffer == Target::kNormal.name) return Target::kSeenNormal.name;
        if (buffer == Target::kPosition.name) return Target::kSeenPosition.name;
        if (buffer == Target::kVisibility.name) return Target::kSeenVisibility.name;
    }
    return of_pixels(buffer);
}

std::string FramePlan::of_pixels(std::string_view buffer) const {
    if (has(Phase::kOccluders)) {
        if (buffer == Target::kDepth.name) return Target::kOccluderDepth.name;
        if (buffer == Target::kNormal.name) return Target::kOccluderNormal.name;
        if (buffer == Target::kPosition.name) return Target::kOccluderPosition.name;
        if (buffer == Target::kVisibility.name) return Target::kOccluderVisibility.name;
    }
    return std::string(buffer);
}

std::string FramePlan::linear_image() const {
    return (makes_colour ? Target::kColour : Target::kHdr).name;
}

std::string FramePlan::image() const {
    return (has(Phase::kResolve) ? Target::kResolved : Target::kDisplay).name;
}

SceneNeeds needs_of(const Scene& scene, const Lighting& lighting) {
    return needs_of(scene.materials, bounds_of(scene), lighting);
}

SceneNeeds needs_of(const std::vector<Material>& materials, const Bounds& bounds,
                    const Lighting& lighting) {
    SceneNeeds needs;
    needs.environment = lighting.environment != nullptr;
    needs.irradiance_grid = lighting.wants_probes();
    needs.lights = static_cast<int>(lighting.lights.size());
    needs.point_lights = static_cast<int>(lighting.point_lights.size());
    needs.tone_mapping = lighting.tone_mapping.has_value();
    for (const Material& material : materials) {
        if (material.normal_texture != kNoTexture) needs.normal_mapping = lighting.normal_mapping;
        if (material.albedo_texture != kNoTexture) needs.textures = true;
        if (material.specular_intensity > 0.0F && needs.direct_light()) needs.specular = true;
        if (material.roughness_texture != kNoTexture && needs.direct_light()) {
            needs.specular = needs.roughness = true;
        }
        if (material.coverage == Coverage::kCutOut) needs.cut_out = true;
        if (material.coverage == Coverage::kBlended) needs.blended = true;
        if (material.emissive != glm::vec3(0.0F)) needs.emission = true;
        if (material.occlusion_texture != kNoTexture) needs.emission = true;
    }
    if (needs.lights > 0) needs.shadow_size = shadow_map_size(bounds);
    if (needs.point_lights > 0) needs.point_shadow_size = kPointShadowSize;
    return needs;
}

}  // namespace obscura::renderer
