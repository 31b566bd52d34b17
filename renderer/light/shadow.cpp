// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/light/shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace obscura::renderer {
namespace {

/// From [-1, 1] to [0, 1] in all three directions.
glm::mat4 unit_from_clip() {
    return glm::scale(glm::translate(glm::mat4(1.0F), glm::vec3(0.5F)), glm::vec3(0.5F));
}

}  // namespace

Bounds bounds_of(const Scene& scene) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Bounds bounds{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
    for (const Mesh& mesh : scene.meshes) {
        for (const Vertex& vertex : mesh.vertices) {
            bounds.low_m = glm::min(bounds.low_m, vertex.position_m);
            bounds.high_m = glm::max(bounds.high_m, vertex.position_m);
        }
    }
    return bounds.low_m.x <= bounds.high_m.x ? bounds : Bounds{};
}

int shadow_map_size(const Bounds& bounds) {
    const float diameter_m = glm::length(bounds.high_m - bounds.low_m);
    int size = 1024;
    while (size < 4096 && diameter_m / static_cast<float>(size) > 0.01F) size *= 2;
    return size;
}

ShadowView shadow_view(const Bounds& bounds, const DirectionalLight& light, int size) {
    const glm::vec3 towards = glm::normalize(light.towards_light);
    const glm::vec3 up =
        std::abs(towards.y) > 0.99F ? glm::vec3(0.0F, 0.0F, 1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
    const glm::mat4 light_from_world = glm::lookAt(glm::vec3(0.0F), -towards, up);

    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    glm::vec3 low(kInfinity);
    glm::vec3 high(-kInfinity);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 world((corner & 1) != 0 ? bounds.high_m.x : bounds.low_m.x,
                              (corner & 2) != 0 ? bounds.high_m.y : bounds.low_m.y,
                              (corner & 4) != 0 ? bounds.high_m.z : bounds.low_m.z);
        const glm::vec3 seen = glm::vec3(light_from_world * glm::vec4(world, 1.0F));
        low = glm::min(low, seen);
        high = glm::max(high, seen);
    }
    // A border of two texels keeps the filter inside the map; depth keeps a little room as well.
    const float extent_m = std::max({high.x - low.x, high.y - low.y, 1e-3F});
    const float border_m = 2.0F * extent_m / static_cast<float>(size - 4);
    const glm::vec2 middle = 0.5F * (glm::vec2(low) + glm::vec2(high));
    const float half_m = 0.5F * extent_m + border_m;
    const float room_m = 0.01F * extent_m;
    const glm::mat4 clip_from_light =
        glm::ortho(middle.x - half_m, middle.x + half_m, middle.y - half_m, middle.y + half_m,
                   -high.z - room_m, -low.z + room_m);
    ShadowView view;
    view.clip_from_world = clip_from_light * light_from_world;
    view.shadow_from_world = unit_from_clip() * view.clip_from_world;
    view.texel_m = 2.0F * half_m / static_cast<float>(size);
    return view;
}

ShadowView point_shadow_view(const Bounds& bounds, const PointLight& light, int side) {
    static const glm::vec3 kAlong[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                       {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    const glm::vec3 along = kAlong[side];
    const glm::vec3 up = along.y != 0.0F ? glm::vec3(0.0F, 0.0F, 1.0F) : glm::vec3(0, 1, 0);
    const glm::vec3 reach_m = glm::max(glm::abs(bounds.low_m - light.position_m),
                                       glm::abs(bounds.high_m - light.position_m));
    const float far_m = std::max(1.01F * glm::length(reach_m), 1e-3F);
    const float near_m = std::min(1e-3F * far_m, 1e-3F);
    // A border of four texels beyond the quarter turn keeps the filter inside the map.
    const float tangent = 1.0F / (1.0F - 8.0F / static_cast<float>(kPointShadowSize));
    const glm::mat4 clip_from_light =
        glm::perspective(2.0F * std::atan(tangent), 1.0F, near_m, far_m);
    ShadowView view;
    view.clip_from_world =
        clip_from_light * glm::lookAt(light.position_m, light.position_m + along, up);
    view.shadow_from_world = unit_from_clip() * view.clip_from_world;
    view.texel_m = 2.0F * tangent / static_cast<float>(kPointShadowSize);
    return view;
}

}  // namespace obscura::renderer
