// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/base/check.h"
#include "renderer/denoise/denoise.h"
#include "renderer/light/shadow.h"

namespace obscura::renderer {
namespace {

struct TargetFacts {
    const char* name;
    const char* format;
    std::size_t bytes_per_texel;
};

TargetFacts facts_of(Target target) {
    switch (target) {
        case Target::kAlbedo:
            return {"albedo", "srgb8_alpha8", 4};
        case Target::kNormal:
            return {"normal", "rgba8", 4};
        case Target::kDepth:
            return {"depth", "r32f", 4};
        case Target::kVisibility:
            return {"visibility", "depth24", 4};
        case Target::kShadow:
            return {"shadow", "depth32f", 4};
        case Target::kAccessibility:
            return {"accessibility", "r32f", 4};
        case Target::kDenoiseStep:
            return {"denoise step", "r32f", 4};
        case Target::kDenoised:
            return {"denoised", "r32f", 4};
        case Target::kAmbient:
            return {"ambient light", "rgba16f", 8};
        case Target::kDirect:
            return {"direct light", "rgba16f", 8};
        case Target::kHdr:
            return {"hdr", "rgba16f", 8};
        case Target::kDisplay:
            return {"display", "rgba8", 4};
    }
    return {"", "", 0};
}

/// Adds passes and, with them, the targets they write.
class Planner {
  public:
    Planner(const SceneNeeds& needs, std::string depth_format, int width, int height)
        : depth_format_(std::move(depth_format)) {
        plan_.width = width;
        plan_.height = height;
        plan_.needs = needs;
    }

    void pass(Pass pass, std::vector<Target> reads, std::vector<Target> writes) {
        for (const Target target : writes) {
            if (plan_.find(target) == nullptr) add(target);
        }
        plan_.passes.push_back({pass, std::move(reads), std::move(writes)});
    }

    void leave_out(std::string what, std::string why) {
        plan_.left_out.push_back({std::move(what), std::move(why)});
    }

    FramePlan take() { return std::move(plan_); }

  private:
    void add(Target target) {
        const TargetFacts facts = facts_of(target);
        PlannedTarget planned{target, facts.format, plan_.width, plan_.height, 1, 0};
        std::size_t bytes_per_texel = facts.bytes_per_texel;
        if (target == Target::kDepth && depth_format_ == "r16f") {
            planned.format = depth_format_;
            bytes_per_texel = 2;
        }
        if (target == Target::kShadow) {
            planned.width = planned.height = plan_.needs.shadow_size;
            planned.layers = plan_.needs.lights;
        }
        planned.bytes = bytes_per_texel * static_cast<std::size_t>(planned.width) *
                        static_cast<std::size_t>(planned.height) *
                        static_cast<std::size_t>(planned.layers);
        plan_.targets.push_back(planned);
    }

    std::string depth_format_;
    FramePlan plan_;
};

}  // namespace

std::string to_string(Target target) { return facts_of(target).name; }

std::string to_string(Pass pass) {
    switch (pass) {
        case Pass::kGeometry:
            return "geometry";
        case Pass::kShadow:
            return "shadow";
        case Pass::kAccessibility:
            return "accessibility";
        case Pass::kDenoise:
            return "denoise";
        case Pass::kLight:
            return "light";
        case Pass::kSky:
            return "sky";
        case Pass::kComposite:
            return "composite";
        case Pass::kToneMap:
            return "tone map";
    }
    return "";
}

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

SceneNeeds needs_of(const Scene& scene, const Lighting& lighting) {
    SceneNeeds needs;
    needs.environment = lighting.environment != nullptr;
    needs.lights = static_cast<int>(lighting.lights.size());
    needs.tone_mapping = lighting.tone_mapping.has_value();
    for (const Material& material : scene.materials) {
        if (material.normal_texture != kNoTexture) needs.normal_mapping = lighting.normal_mapping;
        if (material.albedo_texture != kNoTexture) needs.textures = true;
        if (material.specular_intensity > 0.0F && needs.lights > 0) needs.specular = true;
    }
    if (needs.lights > 0) needs.shadow_size = shadow_map_size(bounds_of(scene));
    return needs;
}

FramePlan plan_frame(const SceneNeeds& needs, const TechniqueChoice& choice, int width,
                     int height) {
    base::check_range("resolution", "width", width, 1, 16384);
    base::check_range("resolution", "height", height, 1, 16384);
    for (const ChoiceProblem& problem : problems_of(choice)) {
        throw base::bad_input("{}: {}", problem.key, problem.message);
    }
    const Technique& technique = *find_technique(choice.technique);
    const Denoise& denoise = *find_denoise(choice.denoise);
    const bool accessibility = technique.makes_accessibility();
    const bool denoised = accessibility && denoise.passes > 0;
    const bool lit = needs.environment || needs.lights > 0;
    const bool depth = (accessibility && technique.reads_depth) ||
                       (denoised && denoise.reads_depth) || needs.lights > 0;
    const bool normal = (accessibility && technique.reads_normal) || lit;

    Planner planner(needs, choice.depth_format, width, height);
    std::vector<Target> geometry{Target::kVisibility, Target::kAlbedo};
    if (normal) geometry.push_back(Target::kNormal);
    if (depth) geometry.push_back(Target::kDepth);
    planner.pass(Pass::kGeometry, {}, geometry);
    if (!normal) planner.leave_out("normal", "neither the technique nor the light reads it");
    if (!depth) planner.leave_out("depth", "neither the technique nor a light reads it");
    if (!needs.normal_mapping) planner.leave_out("normal mapping", "the scene asks for none");
    if (!needs.textures) planner.leave_out("albedo texture fetch", "no material has a texture");

    if (needs.lights > 0) {
        planner.pass(Pass::kShadow, {}, {Target::kShadow});
    } else {
        planner.leave_out("shadow", "the scene has no directional light");
    }
    if (accessibility) {
        std::vector<Target> reads;
        if (technique.ray_traced) reads.push_back(Target::kVisibility);
        if (technique.reads_depth) reads.push_back(Target::kDepth);
        if (technique.reads_normal) reads.push_back(Target::kNormal);
        planner.pass(Pass::kAccessibility, reads, {Target::kAccessibility});
    } else {
        planner.leave_out("accessibility", "the technique computes none");
    }
    if (denoised) {
        std::vector<Target> reads{Target::kAccessibility};
        if (denoise.reads_depth) reads.push_back(Target::kDepth);
        std::vector<Target> writes{Target::kDenoised};
        if (denoise.passes > 1) writes.insert(writes.begin(), Target::kDenoiseStep);
        planner.pass(Pass::kDenoise, reads, writes);
    } else {
        planner.leave_out("denoise", accessibility ? "the variant asks for none"
                                                   : "there is no accessibility to denoise");
    }

    const Target image = needs.tone_mapping ? Target::kHdr : Target::kDisplay;
    std::vector<Target> light;
    if (needs.environment) light.push_back(Target::kAmbient);
    if (needs.lights > 0) light.push_back(Target::kDirect);
    if (lit) {
        std::vector<Target> reads{Target::kNormal};
        if (needs.lights > 0) reads.insert(reads.end(), {Target::kDepth, Target::kShadow});
        planner.pass(Pass::kLight, reads, light);
    } else {
        planner.leave_out("light", "constant ambient light needs no buffer");
    }
    if (lit && !needs.specular) planner.leave_out("specular", "no material or no light has any");

    std::vector<Target> composite{Target::kAlbedo};
    if (accessibility) {
        composite.push_back(denoised ? Target::kDenoised : Target::kAccessibility);
    }
    composite.insert(composite.end(), light.begin(), light.end());
    planner.pass(Pass::kComposite, composite, {image});
    if (needs.environment) {
        planner.pass(Pass::kSky, {Target::kVisibility}, {image});
    } else {
        planner.leave_out("sky", "the scene has no environment");
    }
    if (needs.tone_mapping) {
        planner.pass(Pass::kToneMap, {Target::kHdr}, {Target::kDisplay});
    } else {
        planner.leave_out("tone map", "the scene is not HDR");
    }
    return planner.take();
}

}  // namespace obscura::renderer
