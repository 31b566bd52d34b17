// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/job.h"

namespace obscura::renderer {

void Renderer::draw_shadows(Job& job, const Buffer& map, const std::vector<ShadowView>& views) {
    const PlannedTarget& planned = *job.plan.find(map);
    const gl::Framebuffer layer = gl::Framebuffer::make();
    glNamedFramebufferDrawBuffer(layer.name(), GL_NONE);
    glViewport(0, 0, planned.width, planned.height);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glBindVertexArray(job.scene.vertex_array());
    for (std::size_t i = 0; i < views.size(); ++i) {
        glNamedFramebufferTextureLayer(layer.name(), GL_DEPTH_ATTACHMENT, job.frame.texture(map), 0,
                                       static_cast<GLint>(i));
        glBindFramebuffer(GL_FRAMEBUFFER, layer.name());
        constexpr GLfloat kFar = 1.0F;
        glClearNamedFramebufferfv(layer.name(), GL_DEPTH, 0, &kFar);
        for (const bool cut_out : {false, true}) {
            if (cut_out && !job.plan.needs.cut_out) continue;
            gl::Program& shader = program("passes/shadow.vert.glsl", "passes/shadow.frag.glsl",
                                          cut_out ? Defines{"CUT_OUT"} : Defines{});
            shader.use();
            shader.set("u_shadow_clip", views[i].clip_from_world);
            for (const GpuScene::Draw& draw : job.scene.draws()) {
                const Material& material = job.scene.materials()[draw.material];
                if ((material.coverage == Coverage::kCutOut) != cut_out) continue;
                if (cut_out) {
                    const bool has = material.albedo_texture != kNoTexture;
                    shader.set("u_has_albedo_map", has ? 1 : 0);
                    bind(shader, "t_albedo_map",
                         has ? job.scene.texture(material.albedo_texture) : 0, 0);
                    shader.set("u_opacity", material.opacity);
                    shader.set("u_alpha_cutoff", material.alpha_cutoff);
                }
                job.scene.draw(draw);
            }
        }
    }
}

void Renderer::run_shadow(Job& job) {
    const Bounds& bounds = job.scene.bounds();
    if (const PlannedTarget* map = job.plan.find(Target::kShadow)) {
        std::vector<ShadowView> views;
        for (const DirectionalLight& light : job.lighting.lights) {
            views.push_back(shadow_view(bounds, light, map->width));
        }
        draw_shadows(job, Target::kShadow, views);
    }
    if (job.has(Target::kPointShadow)) {
        std::vector<ShadowView> views;
        for (const PointLight& light : job.lighting.point_lights) {
            for (int side = 0; side < 6; ++side) {
                views.push_back(point_shadow_view(bounds, light, side));
            }
        }
        draw_shadows(job, Target::kPointShadow, views);
    }
}

}  // namespace obscura::renderer
