// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cstring>
#include <limits>

#include "renderer/base/error.h"
#include "renderer/denoise/denoise.h"
#include "renderer/frame/job.h"

namespace obscura::renderer {
namespace {

constexpr GLfloat kOpen[] = {1.0F, 1.0F, 1.0F, 1.0F};

}  // namespace

void Renderer::run_accessibility(Job& job) {
    const Technique& technique = *find_technique(job.choice.technique);
    if (technique.ray_traced) return run_traced_accessibility(job);
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

void Renderer::run_traced_accessibility(Job& job) {
    if (!job.traced) {
        throw base::failure("technique {} needs a ray tracer, and this frame has none",
                            job.choice.technique);
    }
    const int width = job.plan.image_width;
    const int height = job.plan.image_height;
    std::vector<float> upper_first = job.traced(job.source, width, height, job.choice);
    const std::vector<std::uint8_t> visibility =
        job.frame.read_bytes(job.plan.seen_by_technique(Target::kVisibility));
    std::vector<float> values(upper_first.size());
    const auto row = static_cast<std::size_t>(width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        for (std::size_t x = 0; x < row; ++x) {
            std::uint32_t depth = 0;
            std::memcpy(&depth, &visibility[(y * row + x) * sizeof depth], sizeof depth);
            // Along a silhouette ray and rasteriser may differ; an empty pixel stays open.
            const bool empty = depth == std::numeric_limits<std::uint32_t>::max();
            const float traced = upper_first[(static_cast<std::size_t>(height) - 1 - y) * row + x];
            values[y * row + x] = empty ? 1.0F : traced;
        }
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(job.frame.texture(Target::kAccessibility), 0, 0, 0, width, height, GL_RED,
                        GL_FLOAT, values.data());
}

void Renderer::bind_accessibility(Job& job, gl::Program& program) {
    bind(program, "t_accessibility", job.frame.texture(job.plan.final_accessibility()), 4);
    if (job.plan.options.supersampling == 1) return;
    bind(program, "t_pixel_depth", job.frame.texture(Target::kOccluderDepth), 5);
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
