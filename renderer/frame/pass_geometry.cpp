// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/job.h"
#include "renderer/passes/shared_constants.h"

namespace obscura::renderer {
namespace {

void clear(GLuint framebuffer, GLint slot, const glm::vec4& value) {
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, slot, &value.x);
}

}  // namespace

void Renderer::run_geometry(Job& job) {
    const SceneNeeds& needs = job.plan.needs;
    Defines defines;
    if (job.has(Target::kNormal)) defines.emplace_back("NORMAL");
    if (job.has(Target::kDepth)) defines.emplace_back("DEPTH");
    if (needs.textures) defines.emplace_back("TEXTURES");
    const bool normal_mapping = needs.normal_mapping && job.has(Target::kNormal);
    if (normal_mapping) defines.emplace_back("NORMAL_MAPPING");
    gl::Program& shader =
        program("passes/geometry.vert.glsl", "passes/geometry.frag.glsl", defines);

    attach(job, {Target::kAlbedo, Target::kNormal, Target::kDepth});
    clear(framebuffer_.name(), 0, glm::vec4(0.0F));
    if (job.has(Target::kNormal)) clear(framebuffer_.name(), 1, glm::vec4(0.0F));
    if (job.has(Target::kDepth)) clear(framebuffer_.name(), 2, glm::vec4(kBackgroundDepth_m));
    constexpr GLfloat kFar = 1.0F;
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &kFar);

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_FRAMEBUFFER_SRGB);  // the albedo target stores sRGB code values
    shader.use();
    shader.set("u_view", glm::mat3(job.camera.view_from_world));
    shader.set("u_eye_m", job.camera.eye_m);
    shader.set("u_projection", job.camera.clip_from_view);
    glBindVertexArray(job.scene.vertex_array());
    for (const GpuScene::Draw& draw : job.scene.draws()) {
        const Material& material = job.scene.materials()[draw.material];
        shader.set("u_albedo", material.albedo);
        shader.set("u_specular_intensity", material.specular_intensity);
        shader.set("u_specular_power", material.specular_power);
        if (needs.textures) {
            const bool has = material.albedo_texture != kNoTexture;
            shader.set("u_has_albedo_map", has ? 1 : 0);
            bind(shader, "t_albedo_map", has ? job.scene.texture(material.albedo_texture) : 0, 0);
        }
        if (normal_mapping) {
            const bool has = material.normal_texture != kNoTexture;
            shader.set("u_has_normal_map", has ? 1 : 0);
            bind(shader, "t_normal_map", has ? job.scene.texture(material.normal_texture) : 0, 1);
        }
        if (material.double_sided) {
            glDisable(GL_CULL_FACE);
        } else {
            glEnable(GL_CULL_FACE);
        }
        glDrawElementsBaseVertex(
            GL_TRIANGLES, draw.index_count, GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(draw.first_index * sizeof(std::uint32_t)),
            draw.base_vertex);
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

void Renderer::run_shadow(Job& job) {
    gl::Program& shader = program("passes/shadow.vert.glsl", "passes/shadow.frag.glsl", {});
    const PlannedTarget& map = *job.plan.find(Target::kShadow);
    const gl::Framebuffer layer = gl::Framebuffer::make();
    glNamedFramebufferDrawBuffer(layer.name(), GL_NONE);
    glViewport(0, 0, map.width, map.height);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    shader.use();
    glBindVertexArray(job.scene.vertex_array());
    for (std::size_t i = 0; i < job.lighting.lights.size(); ++i) {
        glNamedFramebufferTextureLayer(layer.name(), GL_DEPTH_ATTACHMENT,
                                       job.frame.texture(Target::kShadow), 0,
                                       static_cast<GLint>(i));
        glBindFramebuffer(GL_FRAMEBUFFER, layer.name());
        constexpr GLfloat kFar = 1.0F;
        glClearNamedFramebufferfv(layer.name(), GL_DEPTH, 0, &kFar);
        const ShadowView view = shadow_view(job.scene.bounds(), job.lighting.lights[i], map.width);
        shader.set("u_shadow_clip", view.clip_from_world);
        for (const GpuScene::Draw& draw : job.scene.draws()) {
            glDrawElementsBaseVertex(
                GL_TRIANGLES, draw.index_count, GL_UNSIGNED_INT,
                reinterpret_cast<const void*>(draw.first_index * sizeof(std::uint32_t)),
                draw.base_vertex);
        }
    }
}

}  // namespace obscura::renderer
