// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/base/check.h"
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {
namespace {

/// Adds passes and, with them, the targets they write.
class Planner {
  public:
    Planner(const SceneNeeds& needs, const TechniqueChoice& choice, const FrameOptions& options,
            int width, int height)
        : depth_format_(choice.depth_format),
          technique_(*find_technique(choice.technique)),
          denoise_(*find_denoise(choice.denoise)) {
        plan_.width = width * options.supersampling;
        plan_.height = height * options.supersampling;
        plan_.image_width = width;
        plan_.image_height = height;
        plan_.options = options;
        plan_.needs = needs;
        plan_.technique_reads_depth = technique_.reads_depth;
        accessibility_ = technique_.makes_accessibility();
    }

    void plan_geometry();
    void plan_shadow();
    void plan_accessibility();
    void plan_light();
    void plan_image();

    FramePlan take() { return std::move(plan_); }

  private:
    void pass(Pass pass, std::vector<Target> reads, std::vector<Target> writes) {
        for (const Target target : writes) {
            if (plan_.find(target) == nullptr) add(target);
        }
        plan_.passes.push_back({pass, std::move(reads), std::move(writes)});
    }

    void leave_out(std::string what, std::string why) {
        plan_.left_out.push_back({std::move(what), std::move(why)});
    }

    void add(Target target) {
        const TargetFormat format = format_of(target);
        PlannedTarget planned{target, format.name, plan_.width, plan_.height, 1, 0};
        std::size_t bytes_per_texel = format.bytes_per_texel;
        if ((target == Target::kDepth || target == Target::kOccluderDepth) &&
            depth_format_ == "r16f") {
            planned.format = depth_format_;
            bytes_per_texel = 2;
        }
        if (target == Target::kShadow) {
            planned.width = planned.height = plan_.needs.shadow_size;
            planned.layers = plan_.needs.lights;
        }
        if (target == Target::kPointShadow) {
            planned.width = planned.height = plan_.needs.point_shadow_size;
            planned.layers = 6 * plan_.needs.point_lights;
        }
        if (is_once_a_pixel(target)) {
            planned.width = plan_.image_width;
            planned.height = plan_.image_height;
        }
        planned.bytes = bytes_per_texel * static_cast<std::size_t>(planned.width) *
                        static_cast<std::size_t>(planned.height) *
                        static_cast<std::size_t>(planned.layers);
        plan_.targets.push_back(planned);
    }

    const SceneNeeds& needs() const { return plan_.needs; }
    [[nodiscard]] bool lit() const { return needs().environment || needs().direct_light(); }
    /// Whether the technique runs on fewer pixels than the other passes.
    [[nodiscard]] bool once_a_pixel() const {
        return accessibility_ && plan_.options.supersampling > 1;
    }
    [[nodiscard]] bool occluders() const { return once_a_pixel() || plan_.blended_occlude(); }
    [[nodiscard]] bool denoised() const { return accessibility_ && denoise_.passes > 0; }

    const std::string depth_format_;
    const Technique& technique_;
    const Denoise& denoise_;
    bool accessibility_ = false;
    std::vector<Target> light_;  ///< buffers that the light pass writes
    FramePlan plan_;
};

void Planner::plan_geometry() {
    const bool all = plan_.options.all_buffers;
    // Where the technique runs once a pixel, samples find their pixel by depth.
    const bool depth = all || once_a_pixel() || (accessibility_ && technique_.reads_depth) ||
                       (denoised() && denoise_.reads_depth) || needs().direct_light();
    const bool normal =
        all || (accessibility_ && technique_.reads_normal && !once_a_pixel()) || lit();
    std::vector<Target> writes{Target::kVisibility, Target::kAlbedo};
    if (normal) writes.push_back(Target::kNormal);
    if (depth) writes.push_back(Target::kDepth);
    if (needs().emission) writes.push_back(Target::kEmission);
    pass(Pass::kGeometry, {}, writes);
    if (!normal) {
        leave_out("normal", accessibility_ && technique_.reads_normal
                                ? "the light reads none, and the technique has its own"
                                : "neither the technique nor the light reads it");
    }
    if (!depth) leave_out("depth", "neither the technique nor a light reads it");
    if (!needs().emission) {
        leave_out("emission", "no material sends out light or has baked accessibility");
    }
    if (!needs().normal_mapping) leave_out("normal mapping", "the scene asks for none");
    if (!needs().textures) leave_out("albedo texture fetch", "no material has a texture");
    if (!needs().roughness) {
        leave_out("roughness texture fetch", "no material or no light has any use for it");
    }
    if (!needs().cut_out) leave_out("cut-out test", "no material has holes");
}

void Planner::plan_shadow() {
    std::vector<Target> writes;
    if (needs().lights > 0) writes.push_back(Target::kShadow);
    if (needs().point_lights > 0) writes.push_back(Target::kPointShadow);
    if (!writes.empty()) pass(Pass::kShadow, {}, writes);
    if (needs().lights == 0) leave_out("shadow", "the scene has no directional light");
    if (needs().point_lights == 0) leave_out("point shadow", "the scene has no point light");
}

void Planner::plan_accessibility() {
    if (occluders()) {
        std::vector<Target> reads;
        std::vector<Target> writes{Target::kOccluderVisibility, Target::kOccluderDepth};
        if (technique_.reads_normal) writes.push_back(Target::kOccluderNormal);
        if (!once_a_pixel()) {  // copied from the image's own
            reads = {Target::kVisibility, Target::kDepth};
            if (technique_.reads_normal) reads.push_back(Target::kNormal);
        }
        pass(Pass::kOccluders, reads, writes);
    } else {
        leave_out("occluders", !accessibility_    ? "the technique computes no accessibility"
                               : !needs().blended ? "no material is blended"
                               : !technique_.reads_depth
                                   ? "the technique reads no depth"
                                   : "blended surfaces are asked not to occlude");
    }
    if (!accessibility_) {
        leave_out("accessibility", "the technique computes none");
        leave_out("denoise", "there is no accessibility to denoise");
        return;
    }
    std::vector<Target> reads;
    if (technique_.ray_traced) reads.push_back(plan_.seen_by_technique(Target::kVisibility));
    if (technique_.reads_depth) reads.push_back(plan_.seen_by_technique(Target::kDepth));
    if (technique_.reads_normal) reads.push_back(plan_.seen_by_technique(Target::kNormal));
    pass(Pass::kAccessibility, reads, {Target::kAccessibility});
    if (!denoised()) {
        leave_out("denoise", "the variant asks for none");
        return;
    }
    std::vector<Target> denoise_reads{Target::kAccessibility};
    if (denoise_.reads_depth) denoise_reads.push_back(plan_.seen_by_technique(Target::kDepth));
    std::vector<Target> writes{Target::kDenoised};
    if (denoise_.passes > 1) writes.insert(writes.begin(), Target::kDenoiseStep);
    pass(Pass::kDenoise, denoise_reads, writes);
}

void Planner::plan_light() {
    if (needs().environment) light_.push_back(Target::kAmbient);
    if (needs().direct_light()) light_.push_back(Target::kDirect);
    if (!lit()) {
        leave_out("light", "constant ambient light needs no buffer");
        return;
    }
    std::vector<Target> reads{Target::kNormal};
    if (needs().direct_light()) reads.push_back(Target::kDepth);
    if (needs().lights > 0) reads.push_back(Target::kShadow);
    if (needs().point_lights > 0) reads.push_back(Target::kPointShadow);
    pass(Pass::kLight, reads, light_);
    if (!needs().specular) leave_out("specular", "no material or no light has any");
}

void Planner::plan_image() {
    const Target image = needs().hdr() ? Target::kHdr : Target::kDisplay;
    std::vector<Target> reads{Target::kAlbedo};
    if (accessibility_) reads.push_back(plan_.final_accessibility());
    if (once_a_pixel()) {
        reads.push_back(Target::kDepth);
        reads.push_back(Target::kOccluderDepth);
    }
    reads.insert(reads.end(), light_.begin(), light_.end());
    if (needs().emission) reads.push_back(Target::kEmission);
    pass(Pass::kComposite, reads, {image});
    if (needs().environment) {
        pass(Pass::kSky, {Target::kVisibility}, {image});
    } else {
        leave_out("sky", "the scene has no environment");
    }
    if (needs().blended) {
        std::vector<Target> seen{Target::kVisibility};
        if (needs().lights > 0) seen.push_back(Target::kShadow);
        if (needs().point_lights > 0) seen.push_back(Target::kPointShadow);
        if (plan_.blended_occlude()) {
            seen.push_back(plan_.final_accessibility());
            if (once_a_pixel()) seen.push_back(Target::kOccluderDepth);
        }
        pass(Pass::kBlend, seen, {image});
    } else {
        leave_out("blend", "no material is blended");
    }
    if (needs().hdr()) {
        pass(Pass::kToneMap, {Target::kHdr}, {Target::kDisplay});
    } else {
        leave_out("tone map", "the scene is not HDR");
    }
    if (plan_.options.supersampling > 1) {
        pass(Pass::kResolve, {Target::kDisplay}, {Target::kResolved});
    } else {
        leave_out("resolve", "each pixel takes one sample");
    }
}

}  // namespace

const PlannedTarget* FramePlan::find(Target target) const {
    const auto found = std::find_if(targets.begin(), targets.end(), [target](const auto& planned) {
        return planned.target == target;
    });
    return found == targets.end() ? nullptr : &*found;
}

bool FramePlan::has(Pass pass) const {
    return std::any_of(passes.begin(), passes.end(),
                       [pass](const PlannedPass& planned) { return planned.pass == pass; });
}

std::size_t FramePlan::bytes() const {
    std::size_t sum = 0;
    for (const PlannedTarget& planned : targets) sum += planned.bytes;
    return sum;
}

Target FramePlan::final_accessibility() const {
    return has(Pass::kDenoise) ? Target::kDenoised : Target::kAccessibility;
}

bool FramePlan::blended_occlude() const {
    return technique_reads_depth && needs.blended && options.occluding_opacity.has_value();
}

Target FramePlan::seen_by_technique(Target target) const {
    if (!has(Pass::kOccluders)) return target;
    switch (target) {
        case Target::kDepth:
            return Target::kOccluderDepth;
        case Target::kNormal:
            return Target::kOccluderNormal;
        case Target::kVisibility:
            return Target::kOccluderVisibility;
        default:
            return target;
    }
}

Target FramePlan::image() const {
    return has(Pass::kResolve) ? Target::kResolved : Target::kDisplay;
}

SceneNeeds needs_of(const Scene& scene, const Lighting& lighting) {
    return needs_of(scene.materials, bounds_of(scene), lighting);
}

SceneNeeds needs_of(const std::vector<Material>& materials, const Bounds& bounds,
                    const Lighting& lighting) {
    SceneNeeds needs;
    needs.environment = lighting.environment != nullptr;
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

FramePlan plan_frame(const SceneNeeds& needs, const TechniqueChoice& choice, int width, int height,
                     const FrameOptions& options) {
    base::check_range("resolution", "supersampling", options.supersampling, 1, kMostSupersampling);
    const int most = 16384 / options.supersampling;
    base::check_range("resolution", "width", width, 1, most);
    base::check_range("resolution", "height", height, 1, most);
    if (options.occluding_opacity) {
        base::check_above("blended surfaces", "occluding opacity", *options.occluding_opacity, 0.0F,
                          1.0F);
    }
    for (const VariantProblem& problem : problems_of(choice)) {
        throw base::bad_input("{}: {}", problem.key, problem.message);
    }
    Planner planner(needs, choice, options, width, height);
    planner.plan_geometry();
    planner.plan_shadow();
    planner.plan_accessibility();
    planner.plan_light();
    planner.plan_image();
    return planner.take();
}

}  // namespace obscura::renderer
