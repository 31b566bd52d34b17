// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"
#include "renderer/frame/job.h"

namespace obscura::renderer {
namespace {

constexpr GLfloat kOpen[] = {1.0F, 1.0F, 1.0F, 1.0F};

}  // namespace

void Renderer::run_accessibility(Job& job) {
    const Technique& technique = *find_technique(job.choice.technique);
    Defines defines{"SAMPLES " + std::to_string(job.choice.samples)};
    if (job.choice.unclamped) defines.emplace_back("UNCLAMPED");
    gl::Program& shader = program("passes/full_screen.vert.glsl", technique.shader, defines);
    attach(job, {Target::kAccessibility}, job.plan.seen_by_technique(Target::kVisibility));
    glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kOpen);
    job.set_view(shader);
    shader.set("u_far_m", job.camera.far_m);
    for (const Parameter& parameter : technique.parameters) {
        shader.set(("p_" + parameter.name).c_str(),
                   static_cast<float>(job.choice.value_of(parameter)));
    }
    bind(shader, "t_depth", job.seen(Target::kDepth), 0);
    bind(shader, "t_rotations", rotations_.name(), 1);
    if (technique.reads_normal) {
        bind(shader, "t_normal", job.seen(Target::kNormal), 2);
        bind(shader, "t_kernel", kernel(job.choice.samples).name(), 3);
    }
    full_screen(shader, GL_GREATER);
}

void Renderer::run_denoise(Job& job) {
    const Denoise& denoise = *find_denoise(job.choice.denoise);
    gl::Program& shader = program("passes/full_screen.vert.glsl", denoise.shader, {});
    for (int pass = 0; pass < denoise.passes; ++pass) {
        const bool last = pass + 1 == denoise.passes;
        const Target source = pass == 0 ? Target::kAccessibility : Target::kDenoiseStep;
        attach(job, {last ? Target::kDenoised : Target::kDenoiseStep},
               job.plan.seen_by_technique(Target::kVisibility));
        glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kOpen);
        bind(shader, "t_accessibility", job.frame.texture(source), 0);
        if (denoise.reads_depth) bind(shader, "t_depth", job.seen(Target::kDepth), 1);
        shader.set("u_direction", pass == 0 ? glm::vec2(1.0F, 0.0F) : glm::vec2(0.0F, 1.0F));
        full_screen(shader, GL_GREATER);
    }
}

}  // namespace obscura::renderer
