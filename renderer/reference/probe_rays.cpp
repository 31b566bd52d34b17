// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/probe_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/light/shadow.h"
#include "renderer/scene/scene_check.h"

namespace obscura::renderer {
namespace {

/// IEC 61966-2-1, 5.2.
float linear_from_srgb_code(std::uint8_t code) {
    const float value = static_cast<float>(code) / 255.0F;
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

/// Of some thousand texels that lie evenly; where a cut-out has holes they count little.
glm::vec3 mean_colour(const Scene& scene, TextureIndex index) {
    if (index == kNoTexture) return glm::vec3(1.0F);
    const Texture& texture = scene.textures[static_cast<std::size_t>(index)];
    check_texture(scene, texture);
    constexpr std::size_t kMostTexels = 4096;
    const std::size_t texels = texture.rgba.size() / 4;
    // Odd, so that it does not keep to some columns of a texture whose width is a power of two.
    const std::size_t step = (texels / kMostTexels) | 1;
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (std::size_t i = 0; i < texels; i += step) {
        const std::uint8_t* texel = &texture.rgba[4 * i];
        const double weight = texel[3] / 255.0 + 1e-6;
        for (int c = 0; c < 3; ++c) {
            sum[c] +=
                weight * static_cast<double>(texture.srgb ? linear_from_srgb_code(texel[c])
                                                          : static_cast<float>(texel[c]) / 255.0F);
        }
        weights += weight;
    }
    return glm::vec3(sum / weights);
}

/// As passes/lighting.glsl has it: what a cone lets through along a direction from the light.
float through_cone(const PointLight& light, const glm::vec3& from_light) {
    if (light.outer_cone_rad >= std::numbers::pi_v<float>) return 1.0F;
    const float outer = std::cos(light.outer_cone_rad);
    const float inner = std::max(std::cos(light.inner_cone_rad), outer + 1e-4F);
    return glm::smoothstep(outer, inner, glm::dot(from_light, glm::normalize(light.direction)));
}

}  // namespace

ProbeRays::ProbeRays(const Scene& scene)
    : scene_(scene), rays_(scene, RayScene::Kernels::kWithoutFusedMultiplication) {
    for (const Material& material : scene.materials) {
        check_textures(scene, material);
        surfaces_.push_back(
            {material.albedo * mean_colour(scene, material.albedo_texture),
             material.emissive == glm::vec3(0.0F)
                 ? glm::vec3(0.0F)
                 : material.emissive * mean_colour(scene, material.emissive_texture)});
    }
    const Bounds bounds = bounds_of(scene);
    off_m_ = 1e-4F * glm::length(bounds.high_m - bounds.low_m);
}

ProbeHit ProbeRays::trace(const glm::vec3& from_m, const glm::vec3& direction) const {
    const glm::vec3 start(glm::dvec3(from_m) - rays_.origin_m());
    RTCRayHit found{ray_from(start, direction, 0.0F, std::numeric_limits<float>::infinity()), {}};
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RayScene::Context context(false);  // probes see every side
    rtcIntersect1(rays_.embree(), &context, &found);
    ProbeHit hit;
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
    const RayScene::Geometry& geometry = rays_.geometry(found.hit.geomID);
    const auto [corner, normals] = rays_.triangle(found.hit.geomID, found.hit.primID);
    // Embree's own distance is an approximation that differs between processors.
    const glm::dvec3 across =
        glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
    const glm::dvec3 along(direction);
    const double facing = glm::dot(across, along);
    const double t_m = facing != 0.0 ? glm::dot(across, corner[0] - glm::dvec3(start)) / facing
                                     : static_cast<double>(found.ray.tfar);
    hit.point_m = glm::dvec3(start) + along * t_m + rays_.origin_m();
    hit.normal = facing > 0.0 ? -across : across;
    hit.kind =
        facing > 0.0 && geometry.single_sided ? ProbeHit::Kind::kBack : ProbeHit::Kind::kFront;
    const Mesh& mesh = scene_.meshes[geometry.mesh];
    glm::vec3 colour(0.0F);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex =
            geometry.indices[3 * static_cast<std::size_t>(found.hit.primID) + i];
        colour += glm::vec3(mesh.vertices[vertex].color) / (3.0F * 255.0F);
    }
    const Surface& surface = surfaces_[mesh.material];
    hit.albedo = glm::clamp(surface.albedo * colour, 0.0F, 1.0F);
    hit.emitted = surface.emitted;
    return hit;
}

bool ProbeRays::sees(const glm::vec3& from_m, const glm::vec3& direction, float far_m) const {
    RTCRay ray = ray_from(glm::vec3(glm::dvec3(from_m) - rays_.origin_m()), direction, 0.0F, far_m);
    RayScene::Context context(false);
    rtcOccluded1(rays_.embree(), &context, &ray);
    return ray.tfar >= 0.0F;
}

glm::vec3 ProbeRays::direct_light(const Lighting& light, const glm::vec3& point_m,
                                  const glm::vec3& normal) const {
    constexpr float kInversePi = std::numbers::inv_pi_v<float>;
    const glm::vec3 start = point_m + off_m_ * normal;
    glm::vec3 sum(0.0F);
    for (const DirectionalLight& sun : light.lights) {
        const glm::vec3 towards = glm::normalize(sun.towards_light);
        const float cosine = glm::dot(normal, towards);
        if (cosine > 0.0F && sees(start, towards, std::numeric_limits<float>::infinity())) {
            sum += sun.irradiance * (cosine * kInversePi);
        }
    }
    for (const PointLight& lamp : light.point_lights) {
        const glm::vec3 way = lamp.position_m - start;
        const float distance_m = glm::length(way);
        if (!(distance_m > off_m_) || distance_m > lamp.range_m) continue;
        const glm::vec3 towards = way / distance_m;
        const float cosine = glm::dot(normal, towards);
        const float cone = through_cone(lamp, -towards);
        if (cosine > 0.0F && cone > 0.0F && sees(start, towards, distance_m)) {
            const float squared = std::max(distance_m * distance_m, 1e-4F);
            sum += lamp.intensity * (cone * cosine * kInversePi / squared);
        }
    }
    return sum;
}

}  // namespace obscura::renderer
