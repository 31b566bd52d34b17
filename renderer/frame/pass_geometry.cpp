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

Renderer::Defines Renderer::surface_defines(const SceneNeeds& needs, bool normal) {
    Defines defines;
    const bool normal_mapping = needs.normal_mapping && normal;
    if (normal) defines.emplace_back("NORMAL");
    if (needs.textures) defines.emplace_back("TEXTURES");
    if (normal_mapping) defines.emplace_back("NORMAL_MAPPING");
    if (needs.roughness) defines.emplace_back("ROUGHNESS");
    if (needs.emission) defines.emplace_back("EMISSION");
    if (needs.textures || normal_mapping || needs.roughness || needs.emission) {
        defines.emplace_back("UV");
    }
    return defines;
}

void Renderer::set_surface(Job& job, gl::Program& program, const Material& material) {
    const SceneNeeds& needs = job.plan.needs;
    const auto map = [&](const char* has, const char* sampler, TextureIndex index, int unit) {
        const bool there = index != kNoTexture;
        program.set(has, there ? 1 : 0);
        bind(program, sampler, there ? job.scene.texture(index) : 0, unit);
    };
    program.set("u_albedo", material.albedo);
    program.set("u_opacity", material.opacity);
    program.set("u_alpha_cutoff", material.alpha_cutoff);
    program.set("u_specular_intensity", material.specular_intensity);
    program.set("u_specular_power", material.specular_power);
    if (needs.textures) map("u_has_albedo_map", "t_albedo_map", material.albedo_texture, 0);
    if (needs.normal_mapping) map("u_has_normal_map", "t_normal_map", material.normal_texture, 1);
    if (needs.roughness) {
        map("u_has_roughness_map", "t_roughness_map", material.roughness_texture, 8);
        program.set("u_roughness", material.roughness);
        program.set("u_metalness", material.metalness);
    }
    if (needs.emission) {
        map("u_has_emissive_map", "t_emissive_map", material.emissive_texture, 2);
        map("u_has_occlusion_map", "t_occlusion_map", material.occlusion_texture, 3);
        const bool baked = material.occlusion_texture != kNoTexture;
        program.set("u_occlusion_strength", baked ? material.occlusion_strength : 0.0F);
        program.set("u_emissive", material.emissive);
    }
    if (material.double_sided) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
    }
}

void Renderer::run_geometry(Job& job) {
    Defines defines = surface_defines(job.plan.needs, job.has(Target::kNormal));
    if (job.has(Target::kDepth)) defines.emplace_back("DEPTH");
    if (job.has(Target::kAlbedo)) defines.emplace_back("ALBEDO");
    if (job.has(Target::kPosition)) defines.emplace_back("POSITION");
    if (!job.has(Target::kEmission)) std::erase(defines, "EMISSION");

    attach(job, {Target::kAlbedo, Target::kNormal, Target::kDepth, Target::kEmission,
                 Target::kPosition});
    if (job.has(Target::kAlbedo)) clear(framebuffer_.name(), 0, glm::vec4(0.0F));
    if (job.has(Target::kNormal)) clear(framebuffer_.name(), 1, glm::vec4(0.0F));
    if (job.has(Target::kDepth)) clear(framebuffer_.name(), 2, glm::vec4(kBackgroundDepth_m));
    if (job.has(Target::kEmission)) clear(framebuffer_.name(), 3, glm::vec4(0, 0, 0, 1));
    if (job.has(Target::kPosition)) clear(framebuffer_.name(), 4, glm::vec4(0.0F));
    glEnable(GL_FRAMEBUFFER_SRGB);  // the albedo target stores sRGB code values
    const bool depth = job.has(Target::kDepth);
    draw_opaque(job, job.camera, "passes/geometry.frag.glsl", defines, [&](gl::Program& shader) {
        if (depth) job.set_place_in_image(shader, job.camera);
    });
    glDisable(GL_FRAMEBUFFER_SRGB);
}

void Renderer::draw_opaque(Job& job, const CameraMatrices& camera, const std::string& fragment,
                           Defines defines, const std::function<void(gl::Program&)>& set) {
    constexpr GLfloat kFar = 1.0F;
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &kFar);
    glBindVertexArray(job.scene.vertex_array());
    const Frustum view(camera);
    // Surfaces without holes first: their shader discards nothing, and what they hide is not
    // shaded.
    for (const bool cut_out : {false, true}) {
        if (cut_out && !job.plan.needs.cut_out) continue;
        if (cut_out) defines.emplace_back("CUT_OUT");
        gl::Program& shader = program("passes/geometry.vert.glsl", fragment, defines);
        shader.use();
        job.set_vertices(shader, camera);
        if (set) set(shader);
        for (const GpuScene::Draw& draw : job.scene.draws()) {
            const Material& material = job.scene.materials()[draw.material];
            if ((material.coverage == Coverage::kCutOut) != cut_out) continue;
            set_surface(job, shader, material);
            GpuScene::draw(draw, view);
            ask_whether_to_go_on(job);
        }
    }
    glDisable(GL_CULL_FACE);
}

}  // namespace obscura::renderer
