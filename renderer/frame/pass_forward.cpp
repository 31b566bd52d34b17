// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/job.h"

namespace obscura::renderer {

Renderer::Defines Renderer::lit_surface_defines(const Job& job, bool occluded) {
    Defines defines = surface_defines(job.plan.needs, true);
    const Defines light = lighting_defines(job.plan.needs);
    defines.insert(defines.end(), light.begin(), light.end());
    if (occluded) {
        defines.emplace_back("ACCESSIBILITY");
        defines.push_back(job.samples_define());
        defines.push_back(job.plan.accessibility_define());
    }
    return defines;
}

void Renderer::run_forward(Job& job) {
    const SceneNeeds& needs = job.plan.needs;
    const bool occluded = job.plan.makes_accessibility();
    Defines defines = lit_surface_defines(job, occluded);
    if (job.plan.hdr()) defines.emplace_back("HDR");
    attach(job, {job.plan.hdr() ? Target::kHdr : Target::kDisplay});
    clear_to_background(job);
    // Depth is tested anew: where faces coincide, the first one drawn is seen, as in a G-buffer.
    draw_opaque(job, job.camera, "passes/forward.frag.glsl", defines, [&](gl::Program& shader) {
        set_lighting(job, shader);
        if (!needs.environment) shader.set("u_ambient", job.lighting.ambient);
        if (occluded) bind_accessibility(job, shader);
    });
}

}  // namespace obscura::renderer
