// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/frame/renderer.h"

namespace obscura::renderer {

/// What the passes of one image share.
struct Renderer::Job {
    const GpuScene& scene;
    const Lighting& lighting;
    const TechniqueChoice& choice;
    const FramePlan& plan;
    CameraMatrices camera;
    Frame& frame;
    const Camera& source;  ///< what `camera` was made of
    const TracedAccessibility& traced;

    [[nodiscard]] bool has(Target target) const { return plan.find(target) != nullptr; }
    /// The buffer that stands in for kDepth, kNormal or kVisibility before the technique.
    [[nodiscard]] GLuint seen(Target target) const {
        return frame.texture(plan.seen_by_technique(target));
    }
    /// From view space to the world, directions only.
    [[nodiscard]] glm::mat3 world_from_view() const {
        return glm::transpose(glm::mat3(camera.view_from_world));
    }
    /// Uniforms of passes/view.glsl.
    void set_view(gl::Program& program) const {
        program.set("u_size", glm::vec2(plan.width, plan.height));
        program.set("u_projection", camera.clip_from_view);
        program.set("u_ray_scale", camera.ray_scale);
        program.set("u_ray_offset", camera.ray_offset);
    }
};

}  // namespace obscura::renderer
