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

const char* define_of(ToneCurve curve) {
    switch (curve) {
        case ToneCurve::kReinhard:
            return "CURVE_REINHARD";
        case ToneCurve::kFilmic:
            return "CURVE_FILMIC";
        case ToneCurve::kAces:
            return "CURVE_ACES";
        case ToneCurve::kClip:
            return "CURVE_CLIP";
    }
    return "";
}

}  // namespace

void Renderer::bind_accessibility(Job& job, gl::Program& program) {
    bind(program, "t_accessibility", job.frame.texture(job.plan.final_accessibility()), 4);
    if (job.plan.options.supersampling == 1) return;
    bind(program, "t_pixel_depth", job.frame.texture(Target::kOccluderDepth), 5);
}

void Renderer::clear_to_background(Job& job) {
    const glm::vec3 background =
        job.plan.hdr() ? job.lighting.background : encode_srgb(job.lighting.background);
    const glm::vec4 empty(background, 1.0F);
    glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, &empty.x);
}

void Renderer::run_composite(Job& job) {
    const SceneNeeds& needs = job.plan.needs;
    const bool occluded = job.plan.makes_accessibility();
    Defines defines;
    if (occluded) {
        defines.emplace_back("ACCESSIBILITY");
        defines.push_back(job.samples_define());
        defines.push_back(job.plan.accessibility_define());
    }
    if (needs.environment) defines.emplace_back("ENVIRONMENT");
    if (needs.direct_light()) defines.emplace_back("DIRECT");
    if (needs.specular) defines.emplace_back("SPECULAR");
    if (needs.emission) defines.emplace_back("EMISSION");
    if (job.plan.hdr()) defines.emplace_back("HDR");
    gl::Program& shader =
        program("passes/full_screen.vert.glsl", "passes/composite.frag.glsl", defines);
    attach(job, {job.plan.hdr() ? Target::kHdr : Target::kDisplay});
    clear_to_background(job);
    bind(shader, "t_albedo", job.frame.texture(Target::kAlbedo), 0);
    if (occluded) {
        bind_accessibility(job, shader);
        if (job.plan.options.supersampling > 1) {
            bind(shader, "t_depth", job.frame.texture(Target::kDepth), 6);
        }
    }
    if (needs.environment) {
        bind(shader, "t_ambient", job.frame.texture(Target::kAmbient), 1);
    } else {
        shader.set("u_ambient", job.lighting.ambient);
    }
    if (needs.direct_light()) bind(shader, "t_direct", job.frame.texture(Target::kDirect), 2);
    if (needs.emission) bind(shader, "t_emission", job.frame.texture(Target::kEmission), 3);
    full_screen(job, shader, GL_GREATER);
}

void Renderer::run_sky(Job& job) {
    Defines defines;
    if (job.plan.hdr()) defines.emplace_back("HDR");
    gl::Program& shader = program("passes/full_screen.vert.glsl", "passes/sky.frag.glsl", defines);
    attach(job, {job.plan.hdr() ? Target::kHdr : Target::kDisplay});
    job.set_view(shader);
    shader.set("u_world_from_view", job.world_from_view());
    bind(shader, "t_environment", environment(job.lighting.environment).texture.name(), 0);
    full_screen(job, shader, GL_EQUAL);
}

void Renderer::run_tone_map(Job& job) {
    // Without tone mapping the image is linear for the sake of blended surfaces only.
    const ToneMapping tone =
        job.lighting.tone_mapping.value_or(ToneMapping{1.0F, 1.0F, ToneCurve::kClip});
    gl::Program& shader = program("passes/full_screen.vert.glsl", "passes/tone_map.frag.glsl",
                                  {define_of(tone.curve)});
    attach(job, {Target::kDisplay});
    bind(shader, "t_hdr", job.frame.texture(job.plan.linear_image()), 0);
    shader.set("u_exposure", tone.exposure);
    shader.set("u_white", tone.white);
    full_screen(job, shader, GL_ALWAYS);
}

void Renderer::run_resolve(Job& job) {
    gl::Program& shader =
        program("passes/full_screen.vert.glsl", "passes/resolve.frag.glsl", {job.samples_define()});
    attach(job, {Target::kResolved}, std::nullopt);
    bind(shader, "t_display", job.frame.texture(Target::kDisplay), 0);
    full_screen(job, shader, GL_ALWAYS);
}

}  // namespace obscura::renderer
