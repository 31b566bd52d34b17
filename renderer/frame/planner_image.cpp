// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/planner.h"

namespace obscura::renderer {

void Planner::plan_geometry() {
    const bool all = plan_.options.all_buffers;
    const bool forward = plan_.lit_forward();
    const bool technique_has_its_own = draws_occluders();
    // Where the technique runs once a pixel, samples find their pixel by depth.
    const bool depth = all || recipe_.reads(Target::kDepth) ||
                       (denoised() && filter_.reads(Target::kDepth)) ||
                       (!forward && (once_a_pixel() || light_reads_depth()));
    const bool read_normal = reads_normal();
    const bool copied =
        read_normal && !technique_has_its_own && plan_.variant.normal_format != "from-depth";
    const bool normal = all || copied || (lit() && !forward);
    const bool position = stores_position() && !technique_has_its_own;
    const bool emission = needs().emission && (!forward || all);
    const bool traced = technique_.is_truth();
    if (forward && !all && (technique_has_its_own || !(depth || traced))) {
        leave_out("geometry", "nothing is read of it before surfaces are drawn and lit");
        return;
    }
    std::vector<Buffer> writes{Target::kVisibility};
    if (!forward || all) writes.push_back(Target::kAlbedo);
    if (normal) writes.push_back(Target::kNormal);
    if (depth) writes.push_back(Target::kDepth);
    if (emission) writes.push_back(Target::kEmission);
    if (position) writes.push_back(Target::kPosition);
    pass(Phase::kGeometry, {}, writes);
    if (!normal) {
        leave_out("normal", read_normal ? "the light reads none, and the technique has its own"
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
    std::vector<Buffer> writes;
    if (needs().lights > 0) writes.push_back(Target::kShadow);
    if (needs().point_lights > 0) writes.push_back(Target::kPointShadow);
    if (!writes.empty()) pass(Phase::kShadow, {}, writes);
    if (needs().lights == 0) leave_out("shadow", "the scene has no directional light");
    if (needs().point_lights == 0) leave_out("point shadow", "the scene has no point light");
}

void Planner::plan_light() {
    if (needs().environment) light_.push_back(Target::kAmbient);
    if (needs().direct_light()) light_.push_back(Target::kDirect);
    if (!lit()) {
        leave_out("light", "constant ambient light needs no buffer");
        return;
    }
    if (plan_.lit_forward() && !plan_.options.all_buffers) {
        leave_out("light", "surfaces are lit while they are drawn");
        return;
    }
    std::vector<Read> reads{Target::kNormal};
    if (light_reads_depth()) reads.emplace_back(Target::kDepth);
    if (needs().lights > 0) reads.emplace_back(Target::kShadow);
    if (needs().point_lights > 0) reads.emplace_back(Target::kPointShadow);
    pass(Phase::kLight, reads, light_);
    if (needs().environment && !needs().irradiance_grid) {
        leave_out("irradiance probes", "the light asks for none");
    }
    if (!needs().specular) leave_out("specular", "no material or no light has any");
}

void Planner::plan_composite() {
    std::vector<Read> reads{Target::kAlbedo};
    if (accessibility_) reads.emplace_back(plan_.final_accessibility());
    if (once_a_pixel()) {
        reads.emplace_back(Target::kDepth);
        reads.emplace_back(Target::kOccluderDepth);
    }
    reads.insert(reads.end(), light_.begin(), light_.end());
    if (needs().emission) reads.emplace_back(Target::kEmission);
    pass(Phase::kComposite, reads, {plan_.hdr() ? Target::kHdr : Target::kDisplay});
}

void Planner::plan_forward() {
    std::vector<Read> reads;
    if (accessibility_) reads.emplace_back(plan_.final_accessibility());
    if (once_a_pixel()) reads.emplace_back(Target::kOccluderDepth);
    if (needs().lights > 0) reads.emplace_back(Target::kShadow);
    if (needs().point_lights > 0) reads.emplace_back(Target::kPointShadow);
    pass(Phase::kForward, reads,
         {Target::kVisibility, plan_.hdr() ? Target::kHdr : Target::kDisplay});
    leave_out("composite", "surfaces are drawn and lit in one");
}

void Planner::plan_image() {
    const Buffer& image = plan_.hdr() ? Target::kHdr : Target::kDisplay;
    if (plan_.lit_forward()) {
        plan_forward();
    } else {
        plan_composite();
    }
    if (needs().environment) {
        pass(Phase::kSky, {Target::kVisibility}, {image});
    } else {
        leave_out("sky", "the scene has no environment");
    }
    if (plan_.makes_colour) plan_steps(recipe_, Phase::kTechnique);
    const Buffer& linear = plan_.makes_colour ? Target::kColour : Target::kHdr;
    if (needs().blended) {
        std::vector<Read> seen{Target::kVisibility};
        if (needs().lights > 0) seen.emplace_back(Target::kShadow);
        if (needs().point_lights > 0) seen.emplace_back(Target::kPointShadow);
        if (plan_.blended_occlude()) {
            seen.emplace_back(plan_.final_accessibility());
            if (once_a_pixel()) seen.emplace_back(Target::kOccluderDepth);
        }
        pass(Phase::kBlend, seen, {linear});
    } else {
        leave_out("blend", "no material is blended");
    }
    if (plan_.hdr()) {
        pass(Phase::kToneMap, {linear}, {Target::kDisplay});
    } else {
        leave_out("tone map", "the scene is not HDR");
    }
    if (plan_.options.supersampling > 1) {
        pass(Phase::kResolve, {Target::kDisplay}, {Target::kResolved});
    } else {
        leave_out("resolve", "each pixel takes one sample");
    }
}

}  // namespace obscura::renderer
