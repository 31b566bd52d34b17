// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "renderer/frame/job.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/recipe/normal_format.h"

namespace obscura::renderer {
namespace {

/// Blended triangles of materials at least that opaque, the furthest first.
std::vector<std::uint32_t> back_to_front(const GpuScene& scene, const CameraMatrices& camera,
                                         float least_opacity) {
    const auto& triangles = scene.blended();
    std::vector<float> depth_m(triangles.size());
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (scene.materials()[triangles[i].material].opacity < least_opacity) continue;
        depth_m[i] = -(camera.view_from_world * glm::vec4(triangles[i].middle_m, 1.0F)).z;
        order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&depth_m](std::uint32_t a, std::uint32_t b) {
        return depth_m[a] > depth_m[b];
    });
    return order;
}

}  // namespace

void Renderer::draw_blended(Job& job, gl::Program& program, float least_opacity) {
    const auto& triangles = job.scene.blended();
    const std::vector<std::uint32_t> order = back_to_front(job.scene, job.camera, least_opacity);
    if (order.empty()) return;
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * order.size());
    for (const std::uint32_t i : order) {
        indices.insert(indices.end(), triangles[i].indices.begin(), triangles[i].indices.end());
    }
    glNamedBufferSubData(job.scene.sorted_indices(), 0,
                         static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                         indices.data());
    program.use();
    glBindVertexArray(job.scene.sorted_vertex_array());
    for (std::size_t first = 0; first < order.size();) {
        const std::uint32_t material = triangles[order[first]].material;
        std::size_t last = first + 1;
        while (last < order.size() && triangles[order[last]].material == material) ++last;
        set_surface(job, program, job.scene.materials()[material]);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * (last - first)), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(3 * first * sizeof(std::uint32_t)));
        first = last;
    }
    glDisable(GL_CULL_FACE);
}

void Renderer::run_occluders(Job& job) {
    const bool normal = job.has(Target::kOccluderNormal);
    Defines defines = surface_defines(job.plan.needs, normal);
    const std::string codec = normal_format_of(job.plan.variant.normal_format).define;
    if (normal && job.plan.own_normals()) defines.push_back(codec);
    const bool position = job.has(Target::kOccluderPosition);
    if (position) defines.emplace_back("POSITION");
    attach(job, {Target::kOccluderDepth, Target::kOccluderNormal, Target::kOccluderPosition},
           Target::kOccluderVisibility);
    if (job.plan.draws_occluders()) {
        constexpr GLfloat kNothing[2][4] = {{kBackgroundDepth_m, 0, 0, 0}, {0, 0, 0, 0}};
        glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kNothing[0]);
        if (normal) glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 1, kNothing[1]);
        if (position) glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 2, kNothing[1]);
        draw_opaque(job, job.camera, "passes/occluders.frag.glsl", defines,
                    [&](gl::Program& shader) { job.set_place_in_image(shader, job.camera); });
    } else {
        const auto copy = [&job](const Buffer& from, const Buffer& to) {
            glCopyImageSubData(job.frame.texture(from), GL_TEXTURE_2D, 0, 0, 0, 0,
                               job.frame.texture(to), GL_TEXTURE_2D, 0, 0, 0, 0, job.size.x,
                               job.size.y, 1);
        };
        copy(Target::kVisibility, Target::kOccluderVisibility);
        copy(Target::kDepth, Target::kOccluderDepth);
        if (normal) copy(Target::kNormal, Target::kOccluderNormal);
        if (position) copy(Target::kPosition, Target::kOccluderPosition);
    }
    if (!job.plan.blended_occlude()) return;
    defines.emplace_back("BLENDED");
    gl::Program& shader =
        program("passes/geometry.vert.glsl", "passes/occluders.frag.glsl", defines);
    job.set_vertices(shader);
    job.set_place_in_image(shader, job.camera);
    shader.set("u_occluding_opacity", *job.plan.options.occluding_opacity);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    draw_blended(job, shader, *job.plan.options.occluding_opacity);
}

void Renderer::run_blend(Job& job) {
    const SceneNeeds& needs = job.plan.needs;
    const bool occluded = job.plan.blended_occlude();
    const Defines defines = lit_surface_defines(job, occluded);
    gl::Program& shader = program("passes/geometry.vert.glsl", "passes/blend.frag.glsl", defines);
    const std::string image = job.plan.linear_image();
    attach(job, {image});
    job.set_vertices(shader);
    set_lighting(job, shader);
    if (!needs.environment) shader.set("u_ambient", job.lighting.ambient);
    if (occluded) {
        shader.set("u_occluding_opacity", *job.plan.options.occluding_opacity);
        bind_accessibility(job, shader);
    }
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_blended(job, shader, 0.0F);
    glDisable(GL_BLEND);
}

}  // namespace obscura::renderer
