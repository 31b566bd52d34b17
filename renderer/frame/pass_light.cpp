// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/error.h"
#include "renderer/frame/job.h"
#include "renderer/light/irradiance_grid.h"

namespace obscura::renderer {

Renderer::Defines Renderer::lighting_defines(const SceneNeeds& needs) {
    Defines defines;
    if (needs.environment) defines.emplace_back("ENVIRONMENT");
    if (needs.irradiance_grid) defines.emplace_back("IRRADIANCE_GRID");
    if (needs.direct_light()) defines.emplace_back("DIRECT");
    if (needs.lights > 0) defines.push_back("LIGHTS " + std::to_string(needs.lights));
    if (needs.point_lights > 0) {
        defines.push_back("POINT_LIGHTS " + std::to_string(needs.point_lights));
    }
    if (needs.specular) defines.emplace_back("SPECULAR");
    return defines;
}

namespace {

void set_directional_lights(gl::Program& shader, const std::vector<DirectionalLight>& lights,
                            const Bounds& bounds, const CameraMatrices& camera, int map_size) {
    const glm::mat4 world_from_view = glm::inverse(camera.view_from_world);
    std::vector<glm::vec3> towards;
    std::vector<glm::vec3> irradiance;
    std::vector<glm::mat4> shadow;
    float texel_m = 0.0F;
    for (const DirectionalLight& light : lights) {
        const ShadowView view = shadow_view(bounds, light, map_size);
        towards.push_back(glm::mat3(camera.view_from_world) * glm::normalize(light.towards_light));
        irradiance.push_back(light.irradiance);
        shadow.push_back(view.shadow_from_world * world_from_view);
        texel_m = std::max(texel_m, view.texel_m);
    }
    shader.set("u_towards_light", std::span<const glm::vec3>(towards));
    shader.set("u_light_irradiance", std::span<const glm::vec3>(irradiance));
    shader.set("u_shadow_from_view", std::span<const glm::mat4>(shadow));
    shader.set("u_shadow_texel_m", texel_m);
}

void set_point_lights(gl::Program& shader, const std::vector<PointLight>& lights,
                      const Bounds& bounds, const CameraMatrices& camera) {
    const glm::mat4 world_from_view = glm::inverse(camera.view_from_world);
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> intensity;
    std::vector<glm::vec3> axis;
    std::vector<glm::vec3> cone;
    std::vector<glm::mat4> shadow;
    float texel = 0.0F;
    for (const PointLight& light : lights) {
        position.emplace_back(camera.view_from_world * glm::vec4(light.position_m, 1.0F));
        intensity.push_back(light.intensity);
        axis.push_back(glm::mat3(camera.view_from_world) * glm::normalize(light.direction));
        cone.emplace_back(
            std::cos(light.inner_cone_rad),
            light.outer_cone_rad < glm::pi<float>() ? std::cos(light.outer_cone_rad) : -1.0F,
            std::min(light.range_m, 1e17F));
        for (int side = 0; side < 6; ++side) {
            const ShadowView view = point_shadow_view(bounds, light, side);
            shadow.push_back(view.shadow_from_world * world_from_view);
            texel = view.texel_m;
        }
    }
    shader.set("u_point_position", std::span<const glm::vec3>(position));
    shader.set("u_point_intensity", std::span<const glm::vec3>(intensity));
    shader.set("u_point_axis", std::span<const glm::vec3>(axis));
    shader.set("u_point_cone", std::span<const glm::vec3>(cone));
    shader.set("u_point_shadow_from_view", std::span<const glm::mat4>(shadow));
    shader.set("u_point_shadow_texel", texel);
}

void set_probes(gl::Program& shader, const ProbeLattice& lattice, const CameraMatrices& camera) {
    // The difference first, in double precision: eye and probes may be far from the origin.
    const glm::dvec3 eye =
        (glm::dvec3(camera.eye_m) - glm::dvec3(lattice.first_m)) / glm::dvec3(lattice.step_m);
    const glm::dmat3 world_from_view = glm::transpose(glm::dmat3(camera.view_from_world));
    glm::dmat4 probe_from_view = glm::translate(glm::dmat4(1.0), eye + 0.5);
    probe_from_view = glm::scale(probe_from_view, 1.0 / glm::dvec3(lattice.step_m));
    shader.set("u_probe_from_view", glm::mat4(probe_from_view * glm::dmat4(world_from_view)));
    shader.set("u_probe_count", glm::vec3(lattice.count));
}

}  // namespace

void Renderer::set_lighting(Job& job, gl::Program& program) {
    const SceneNeeds& needs = job.plan.needs;
    program.set("u_world_from_view", job.world_from_view());
    if (needs.irradiance_grid) {
        const auto& grid = job.lighting.irradiance_grid;
        if (!grid) throw base::failure("the light asks for probes, and none were baked for it");
        bind(program, "t_probes", texture_of(grid).name(), 8);
        set_probes(program, grid->lattice, job.camera);
    } else if (needs.environment) {
        program.set("u_irradiance_sh",
                    std::span<const glm::vec3>(environment(job.lighting.environment).irradiance));
    }
    if (needs.lights > 0) {
        bind(program, "t_shadow", job.frame.texture(Target::kShadow), 6);
        set_directional_lights(program, job.lighting.lights, job.scene.bounds(), job.camera,
                               job.plan.find(Target::kShadow)->width);
    }
    if (needs.point_lights > 0) {
        bind(program, "t_point_shadow", job.frame.texture(Target::kPointShadow), 7);
        set_point_lights(program, job.lighting.point_lights, job.scene.bounds(), job.camera);
    }
}

void Renderer::run_light(Job& job) {
    const SceneNeeds& needs = job.plan.needs;
    gl::Program& shader =
        program("passes/full_screen.vert.glsl", "passes/light.frag.glsl", lighting_defines(needs));
    attach(job, {Target::kAmbient, Target::kDirect});
    job.set_view(shader);
    set_lighting(job, shader);
    bind(shader, "t_normal", job.frame.texture(Target::kNormal), 0);
    if (needs.direct_light() || needs.irradiance_grid) {
        bind(shader, "t_depth", job.frame.texture(Target::kDepth), 1);
    }
    constexpr GLfloat kDark[] = {0.0F, 0.0F, 0.0F, 0.0F};
    if (needs.environment) glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kDark);
    if (needs.direct_light()) glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 1, kDark);
    full_screen(job, shader, GL_GREATER);
}

}  // namespace obscura::renderer
