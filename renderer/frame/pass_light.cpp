// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "renderer/frame/job.h"

namespace obscura::renderer {
namespace {

/// Linear light to sRGB code values in [0, 1] (IEC 61966-2-1), as passes/display.glsl does.
glm::vec3 encode_srgb(const glm::vec3& linear) {
    glm::vec3 encoded;
    for (int i = 0; i < 3; ++i) {
        const float c = glm::clamp(linear[i], 0.0F, 1.0F);
        encoded[i] = c < 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1.0F / 2.4F) - 0.055F;
    }
    return encoded;
}

}  // namespace

void Renderer::run_light(Job& job) {
    const SceneNeeds& needs = job.plan.needs;
    const auto& lights = job.lighting.lights;
    Defines defines;
    if (needs.environment) defines.emplace_back("ENVIRONMENT");
    if (needs.lights > 0) defines.push_back("LIGHTS " + std::to_string(needs.lights));
    if (needs.specular) defines.emplace_back("SPECULAR");
    gl::Program& shader =
        program("passes/full_screen.vert.glsl", "passes/light.frag.glsl", defines);
    attach(job, {Target::kAmbient, Target::kDirect});
    job.set_view(shader);
    shader.set("u_world_from_view", job.world_from_view());
    bind(shader, "t_normal", job.frame.texture(Target::kNormal), 0);
    if (needs.environment) {
        shader.set("u_irradiance_sh",
                   std::span<const glm::vec3>(environment(job.lighting.environment).irradiance));
    }
    if (needs.lights > 0) {
        bind(shader, "t_depth", job.frame.texture(Target::kDepth), 1);
        bind(shader, "t_shadow", job.frame.texture(Target::kShadow), 2);
        const glm::mat4 world_from_view = glm::inverse(job.camera.view_from_world);
        std::vector<glm::vec3> towards;
        std::vector<glm::vec3> irradiance;
        std::vector<glm::mat4> shadow;
        float texel_m = 0.0F;
        for (const DirectionalLight& light : lights) {
            const ShadowView view =
                shadow_view(job.scene.bounds(), light, job.plan.find(Target::kShadow)->width);
            towards.push_back(glm::mat3(job.camera.view_from_world) *
                              glm::normalize(light.towards_light));
            irradiance.push_back(light.irradiance);
            shadow.push_back(view.shadow_from_world * world_from_view);
            texel_m = std::max(texel_m, view.texel_m);
        }
        shader.set("u_towards_light", std::span<const glm::vec3>(towards));
        shader.set("u_light_irradiance", std::span<const glm::vec3>(irradiance));
        shader.set("u_shadow_from_view", std::span<const glm::mat4>(shadow));
        shader.set("u_shadow_texel_m", texel_m);
    }
    constexpr GLfloat kDark[] = {0.0F, 0.0F, 0.0F, 0.0F};
    if (needs.environment) glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kDark);
    if (needs.lights > 0) glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 1, kDark);
    full_screen(shader, GL_GREATER);
}

void Renderer::run_composite(Job& job) {
    const SceneNeeds& needs = job.plan.needs;
    const bool occluded = job.plan.has(Pass::kAccessibility);
    Defines defines;
    if (occluded) defines.emplace_back("ACCESSIBILITY");
    if (needs.environment) defines.emplace_back("ENVIRONMENT");
    if (needs.lights > 0) defines.emplace_back("LIGHTS");
    if (needs.specular) defines.emplace_back("SPECULAR");
    if (needs.tone_mapping) defines.emplace_back("TONE_MAPPING");
    gl::Program& shader =
        program("passes/full_screen.vert.glsl", "passes/composite.frag.glsl", defines);
    attach(job, {needs.tone_mapping ? Target::kHdr : Target::kDisplay});
    const glm::vec3 background =
        needs.tone_mapping ? job.lighting.background : encode_srgb(job.lighting.background);
    const glm::vec4 empty(background, 1.0F);
    glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, &empty.x);
    bind(shader, "t_albedo", job.frame.texture(Target::kAlbedo), 0);
    if (occluded) {
        bind(shader, "t_accessibility", job.frame.texture(job.plan.final_accessibility()), 1);
    }
    if (needs.environment) {
        bind(shader, "t_ambient", job.frame.texture(Target::kAmbient), 2);
    } else {
        shader.set("u_ambient", job.lighting.ambient);
    }
    if (needs.lights > 0) bind(shader, "t_direct", job.frame.texture(Target::kDirect), 3);
    full_screen(shader, GL_GREATER);
}

void Renderer::run_sky(Job& job) {
    const SceneNeeds& needs = job.plan.needs;
    Defines defines;
    if (needs.tone_mapping) defines.emplace_back("TONE_MAPPING");
    gl::Program& shader = program("passes/full_screen.vert.glsl", "passes/sky.frag.glsl", defines);
    attach(job, {needs.tone_mapping ? Target::kHdr : Target::kDisplay});
    job.set_view(shader);
    shader.set("u_world_from_view", job.world_from_view());
    bind(shader, "t_environment", environment(job.lighting.environment).texture.name(), 0);
    full_screen(shader, GL_EQUAL);
}

void Renderer::run_tone_map(Job& job) {
    gl::Program& shader = program("passes/full_screen.vert.glsl", "passes/tone_map.frag.glsl", {});
    attach(job, {Target::kDisplay});
    bind(shader, "t_hdr", job.frame.texture(Target::kHdr), 0);
    shader.set("u_exposure", job.lighting.tone_mapping->exposure);
    shader.set("u_white", job.lighting.tone_mapping->white);
    full_screen(shader, GL_ALWAYS);
}

}  // namespace obscura::renderer
