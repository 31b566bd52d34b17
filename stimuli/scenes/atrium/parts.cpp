// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/atrium/parts.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;
using renderer::Vertex;

/// Distance from a point inside a rectangle to its border, along a direction.
float to_border(vec2 from, vec2 direction, vec2 low, vec2 high) {
    float distance = 1e9F;
    for (int axis = 0; axis < 2; ++axis) {
        const float wall = direction[axis] > 0.0F ? high[axis] : low[axis];
        if (std::abs(direction[axis]) > 1e-6F) {
            distance = std::min(distance, (wall - from[axis]) / direction[axis]);
        }
    }
    return distance;
}

/// uv of a wall seen from the front: metres, v down.
void map_front(Mesh& mesh) {
    for (Vertex& vertex : mesh.vertices) {
        vertex.uv = vec2(vertex.position_m.x, -vertex.position_m.y);
    }
    make_tangents(mesh);
}

}  // namespace

Site::Site() {
    size_m_ = add_surfaces(scene_);
    for (std::size_t i = 0; i < kSurfaces; ++i) {
        Mesh mesh;
        mesh.name = scene_.materials[i].name;
        mesh.material = static_cast<std::uint32_t>(i);
        scene_.meshes.push_back(std::move(mesh));
    }
}

void Site::put(Surface surface, const Mesh& part, const glm::mat4& transform, std::uint32_t seed,
               const vec3& tint) {
    Placement placement;
    placement.transform = transform;
    placement.uv_scale = 1.0F / size_m_[static_cast<std::size_t>(surface)];
    placement.uv_offset = {hash_unit(static_cast<int>(seed), 1, 0, 5),
                           hash_unit(static_cast<int>(seed), 2, 0, 5)};
    placement.tint = tint;
    append(mesh(surface), part, placement);
}

renderer::Scene Site::take() {
    for (renderer::Mesh& mesh : scene_.meshes) turn_normals_outwards(mesh);
    return std::move(scene_);
}

void Site::put_mapped(Surface surface, const Mesh& part, const glm::mat4& transform,
                      const vec3& tint) {
    Placement placement;
    placement.transform = transform;
    placement.tint = tint;
    append(mesh(surface), part, placement);
}

vec3 shade(std::uint32_t seed, float amount) {
    const int i = static_cast<int>(seed);
    const float tone = 1.0F - amount * hash_unit(i, 0, 0, 901);
    const float warmth = 0.35F * amount * (hash_unit(i, 1, 0, 901) - 0.5F);
    return vec3(tone * (1.0F + std::min(0.0F, warmth)), tone,
                tone * (1.0F - std::max(0.0F, warmth)));
}

Mesh continued(Mesh wall, float along_m) {
    for (Vertex& vertex : wall.vertices) vertex.uv.x += along_m;
    return wall;
}

glm::mat4 side_frame(int side, float wall_x) {
    const float turn = side > 0 ? -glm::half_pi<float>() : glm::half_pi<float>();
    return glm::rotate(at(static_cast<float>(side) * wall_x, 0.0F, 0.0F), turn,
                       vec3(0.0F, 1.0F, 0.0F));
}

Mesh rectangle(vec3 origin, vec3 edge_u, vec3 edge_v, float cell_m) {
    PatchOptions options;
    options.size_m = {glm::length(edge_u), -glm::length(edge_v)};
    options.columns = std::max(1, static_cast<int>(std::ceil(options.size_m.x / cell_m)));
    options.rows = std::max(1, static_cast<int>(std::ceil(-options.size_m.y / cell_m)));
    Mesh mesh = patch(options, [&](float u, float v) { return origin + edge_u * u + edge_v * v; });
    for (Vertex& vertex : mesh.vertices) vertex.tangent.w = -1.0F;
    return mesh;
}

Mesh arch_wall(float x0, float x1, float centre_x, float springing, float radius, float top,
               int rows) {
    PatchOptions options;
    options.columns = 24;
    options.rows = rows;
    const vec2 centre(centre_x, springing);
    // The rays also go through the rectangle's two upper corners, so that the border has no
    // chamfer.
    const float right = std::atan2(top - springing, x1 - centre_x);
    const float left = std::atan2(top - springing, x0 - centre_x);
    Mesh mesh = patch(options, [&](float u, float v) {
        float angle = 0.0F;
        if (u < 0.25F) {
            angle = right * u * 4.0F;
        } else if (u < 0.75F) {
            angle = right + (left - right) * (u - 0.25F) * 2.0F;
        } else {
            angle = left + (glm::pi<float>() - left) * (u - 0.75F) * 4.0F;
        }
        const vec2 direction(std::cos(angle), std::max(0.0F, std::sin(angle)));
        const float border = to_border(centre, direction, {x0, springing}, {x1, top});
        // u turns leftwards, so the outside is +z when v goes inwards.
        const vec2 place = centre + direction * (border + (radius - border) * v);
        return vec3(place, 0.0F);
    });
    for (Vertex& vertex : mesh.vertices) vertex.normal = vec3(0.0F, 0.0F, 1.0F);
    map_front(mesh);
    return mesh;
}

Mesh soffit(float centre_x, float springing, float radius, float z0, float z1) {
    PatchOptions options;
    options.columns = 24;
    options.rows = 2;
    options.size_m = {glm::pi<float>() * radius, std::abs(z1 - z0)};
    return patch(options, [&](float u, float v) {
        const float angle = glm::pi<float>() * u;
        return vec3(centre_x + radius * std::cos(angle), springing + radius * std::sin(angle),
                    z1 + (z0 - z1) * v);
    });
}

void put_voussoirs(Site& site, const Ring& ring, const glm::mat4& transform) {
    const float step = glm::pi<float>() / static_cast<float>(ring.blocks);
    for (int i = 0; i < ring.blocks; ++i) {
        const bool keystone = 2 * i + 1 == ring.blocks;
        const float more = keystone ? 0.035F : 0.0F;
        const float middle = ring.radius + 0.5F * ring.width;
        const float depth = ring.z1 - ring.z0 + 2.0F * more;
        Mesh block = bevelled_box({ring.width + more, middle * step * 0.996F, depth}, 0.014F);
        const float angle = step * (static_cast<float>(i) + 0.5F);
        for (Vertex& vertex : block.vertices) {
            const vec3 p = vertex.position_m;
            const float turn = angle + p.y / middle;
            const float radius = middle + p.x;
            vertex.position_m = {ring.centre_x + radius * std::cos(turn),
                                 ring.springing + radius * std::sin(turn),
                                 0.5F * (ring.z0 + ring.z1) + p.z};
            const auto rotated = [&](const vec3& d) {
                return vec3(d.x * std::cos(turn) - d.y * std::sin(turn),
                            d.x * std::sin(turn) + d.y * std::cos(turn), d.z);
            };
            vertex.normal = rotated(vertex.normal);
            vertex.tangent = glm::vec4(rotated(vec3(vertex.tangent)), vertex.tangent.w);
        }
        const std::uint32_t seed = ring.seed * 64U + static_cast<std::uint32_t>(i);
        // A warmer and a paler stone take turns.
        const vec3 stone = (i & 1) != 0 ? vec3(0.86F, 0.76F, 0.66F) : vec3(1.0F, 0.97F, 0.93F);
        site.put(Surface::kStone, block, transform, seed, stone * shade(seed, 0.16F));
    }
}

Mesh moulding(const std::vector<vec2>& profile, float x0, float x1) {
    std::vector<ProfileFrame> frames;
    const int steps = std::max(1, static_cast<int>(std::ceil((x1 - x0) / 0.3F)));
    for (int i = 0; i <= steps; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(steps);
        // x = y_axis cross z: the profile's x is the wall's z, its y the wall's y, so the path runs
        // along -x.
        frames.push_back(
            {vec3(x1 + (x0 - x1) * t, 0.0F, 0.0F), vec3(0.0F, 0.0F, 1.0F), vec3(0.0F, 1.0F, 0.0F)});
    }
    SweepOptions options;
    options.closed_profile = false;
    return sweep(profile, frames, options);
}

}  // namespace obscura::stimuli::atrium
