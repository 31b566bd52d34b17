// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/job.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/recipe/normal_format.h"

namespace obscura::renderer {

void Renderer::run_seen(Job& job) {
    const FramePlan& plan = job.plan;
    const bool normal = job.has(Target::kSeenNormal);
    const bool position = job.has(Target::kSeenPosition);
    const bool depth_rebuilt = plan.variant.depth_format == "d24";
    const bool normal_rebuilt = plan.variant.normal_format == "from-depth";
    Defines defines{"STEP " + std::to_string(plan.ao_step)};
    if (depth_rebuilt) defines.emplace_back("DEPTH_REBUILT");
    if (normal) defines.emplace_back("NORMAL");
    if (position) defines.emplace_back("POSITION_KEPT");
    if (normal && normal_rebuilt) {
        defines.emplace_back("NORMAL_REBUILT");
        defines.emplace_back(normal_format_of("from-depth").define);
    }
    gl::Program& shader = program("passes/full_screen.vert.glsl", "passes/seen.frag.glsl", defines);
    attach(job, {Target::kSeenDepth, Target::kSeenNormal, Target::kSeenPosition},
           Target::kSeenVisibility);
    job.set_view(shader);
    shader.set("u_near_m", job.source.near_m);
    shader.set("u_far_m", job.source.far_m);
    bind(shader, "t_visibility", job.frame.texture(plan.of_pixels(Target::kVisibility)), 0);
    if (!depth_rebuilt) {
        bind(shader, "t_depth", job.frame.texture(plan.of_pixels(Target::kDepth)), 1);
    }
    if (normal && !normal_rebuilt) {
        bind(shader, "t_normal", job.frame.texture(plan.of_pixels(Target::kNormal)), 2);
    }
    if (position) {
        bind(shader, "t_position", job.frame.texture(plan.of_pixels(Target::kPosition)), 3);
    }
    full_screen(job, shader, GL_ALWAYS, GL_TRUE);
}

void Renderer::run_second_layer(Job& job) {
    const FramePlan& plan = job.plan;
    const int step = plan.second_step;
    attach(job, {Target::kSecondDepth}, Target::kSecondVisibility);
    constexpr GLfloat kNothing[] = {kBackgroundDepth_m, 0, 0, 0};
    glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kNothing);
    const PlannedTarget& first = *plan.find(plan.seen_by_technique(Target::kDepth));
    const Camera fewer = every_so_many(job.seen_source, first.width, first.height, step);
    const GLuint depth = job.frame.texture(first.name);
    Defines defines = surface_defines(plan.needs, false);
    defines.push_back("STEP " + std::to_string(step));
    const CameraMatrices camera = matrices_of(fewer, job.size.x, job.size.y);
    draw_opaque(job, camera, "passes/second_layer.frag.glsl", defines, [&](gl::Program& shader) {
        job.set_place_in_image(shader, camera);
        bind(shader, "t_depth", depth, 4);
        shader.set("u_separation_m", static_cast<float>(plan.separation_m));
    });
}

}  // namespace obscura::renderer
