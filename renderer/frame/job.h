// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/frame/renderer.h"

namespace obscura::renderer {

/// What the passes of one image share.
struct Renderer::Job {
    const GpuScene& scene;
    const Lighting& lighting;
    const FramePlan& plan;
    CameraMatrices camera;
    CameraMatrices seen;  ///< of what the technique sees, and of its second layer
    Frame& frame;
    Camera source;       ///< what `camera` was made of
    Camera seen_source;  ///< the same of `seen`
    const TracedAccessibility& traced;
    const RaysOfScene& rays;
    bool timed;
    const std::function<bool()>& go_on;
    glm::ivec2 size{0};  ///< of the buffers that are attached

    [[nodiscard]] bool has(std::string_view buffer) const { return plan.find(buffer) != nullptr; }
    /// From view space to the world, directions only.
    [[nodiscard]] glm::mat3 world_from_view() const {
        return glm::transpose(glm::mat3(camera.view_from_world));
    }
    /// SUPERSAMPLING n, as shaders read it.
    [[nodiscard]] std::string samples_define() const {
        return "SUPERSAMPLING " + std::to_string(plan.options.supersampling);
    }
    /// Uniforms of passes/geometry.vert.glsl.
    void set_vertices(gl::Program& program, const CameraMatrices& of) const {
        program.set("u_view", glm::mat3(of.view_from_world));
        program.set("u_eye_m", of.eye_m);
        program.set("u_projection", of.clip_from_view);
    }
    void set_vertices(gl::Program& program) const { set_vertices(program, camera); }
    /// Uniforms of passes/view.glsl, for the buffers that are attached.
    void set_view(gl::Program& program, const CameraMatrices& of) const {
        program.set("u_size", glm::vec2(size));
        program.set("u_ray_scale", of.ray_scale);
        program.set("u_ray_offset", of.ray_offset);
        program.set("u_view_from_clip", glm::inverse(of.clip_from_view));
        set_place_in_image(program, of);
    }
    /// Uniforms of passes/depth_of_sample.glsl and of passes/view.glsl, for the attached buffers.
    void set_place_in_image(gl::Program& program, const CameraMatrices& of) const {
        program.set("u_ray_to_px", 0.5F * glm::vec2(size) / of.ray_scale);
        program.set("u_axis_px", 0.5F * glm::vec2(size) * (1.0F - of.ray_offset / of.ray_scale));
    }
    void set_view(gl::Program& program) const { set_view(program, camera); }
};

}  // namespace obscura::renderer
