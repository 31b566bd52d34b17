// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/support/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

glm::mat4 about_x(float turn_rad) {
    return glm::rotate(glm::mat4(1.0F), turn_rad, vec3(1.0F, 0.0F, 0.0F));
}
glm::mat4 about_y(float turn_rad) {
    return glm::rotate(glm::mat4(1.0F), turn_rad, vec3(0.0F, 1.0F, 0.0F));
}
glm::mat4 about_z(float turn_rad) {
    return glm::rotate(glm::mat4(1.0F), turn_rad, vec3(0.0F, 0.0F, 1.0F));
}
glm::mat4 lie_along_x() { return about_z(-glm::half_pi<float>()); }
glm::mat4 lie_along_z() { return about_x(glm::half_pi<float>()); }

float draw(base::Random& random, float low, float high) {
    return static_cast<float>(random.uniform(low, high));
}

vec3 shade_of(std::uint32_t seed, float amount) {
    const int i = static_cast<int>(seed);
    const float tone = 1.0F - amount * hash_unit(i, 0, 0, 901);
    const float warmth = 0.35F * amount * (hash_unit(i, 1, 0, 901) - 0.5F);
    return {tone * (1.0F + std::min(0.0F, warmth)), tone, tone * (1.0F - std::max(0.0F, warmth))};
}

float shared_noise(vec2 uv) {
    static const NoiseTile tile(31, 8, 5);
    return tile.at(uv);
}

Mesh rod(const vec3& from_m, const vec3& to_m, float radius_m, int segments) {
    const std::array<vec3, 2> path{from_m, to_m};
    const vec3 along = glm::normalize(to_m - from_m);
    return sweep(circle(radius_m, segments), frames_along(path, any_perpendicular(along)));
}

std::vector<vec3> rounded_path(std::span<const vec3> corners_m, float bend_m, int steps) {
    std::vector<vec3> path{corners_m.front()};
    for (std::size_t i = 1; i + 1 < corners_m.size(); ++i) {
        const vec3 in = corners_m[i] - corners_m[i - 1];
        const vec3 out = corners_m[i + 1] - corners_m[i];
        const float reach = std::min({bend_m, 0.49F * glm::length(in), 0.49F * glm::length(out)});
        const vec3 a = corners_m[i] - glm::normalize(in) * reach;
        const vec3 b = corners_m[i] + glm::normalize(out) * reach;
        // A quadratic Bezier curve is near enough to an arc for a bend of a pipe.
        for (int k = 0; k <= steps; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(steps);
            path.push_back(glm::mix(glm::mix(a, corners_m[i], t), glm::mix(corners_m[i], b, t), t));
        }
    }
    path.push_back(corners_m.back());
    return path;
}

Mesh pipe(std::span<const vec3> corners_m, float bend_m, float radius_m, int segments) {
    const std::vector<vec3> path = rounded_path(corners_m, bend_m);
    const vec3 along = glm::normalize(path[1] - path[0]);
    return sweep(circle(radius_m, segments), frames_along(path, any_perpendicular(along)));
}

Mesh cable(const vec3& from_m, const vec3& to_m, float sag_m, float radius_m, int pieces) {
    std::vector<vec3> path;
    for (int i = 0; i <= pieces; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(pieces);
        path.push_back(glm::mix(from_m, to_m, t) - vec3(0.0F, 4.0F * sag_m * t * (1.0F - t), 0.0F));
    }
    const vec3 along = glm::normalize(path[1] - path[0]);
    return sweep(circle(radius_m, 8), frames_along(path, any_perpendicular(along)));
}

Mesh slack_cable(std::span<const vec3> through_m, float radius_m, int segments) {
    constexpr int kPieces = 8;
    std::vector<vec3> path;
    for (std::size_t i = 0; i + 1 < through_m.size(); ++i) {
        const vec3& a = through_m[i == 0 ? 0 : i - 1];
        const vec3& b = through_m[i];
        const vec3& c = through_m[i + 1];
        const vec3& d = through_m[std::min(i + 2, through_m.size() - 1)];
        // Slopes by the distances on both sides, so that uneven steps make no loops.
        const float before = std::max(glm::distance(a, b), 1e-4F);
        const float here = glm::distance(b, c);
        const float after = std::max(glm::distance(c, d), 1e-4F);
        const vec3 leave = (c - a) * (here / (before + here));
        const vec3 arrive = (d - b) * (here / (here + after));
        for (int k = i == 0 ? 0 : 1; k <= kPieces; ++k) {
            const float t = static_cast<float>(k) / kPieces;
            const float t2 = t * t;
            const float t3 = t2 * t;
            path.push_back(b * (2.0F * t3 - 3.0F * t2 + 1.0F) + leave * (t3 - 2.0F * t2 + t) +
                           c * (3.0F * t2 - 2.0F * t3) + arrive * (t3 - t2));
        }
    }
    const vec3 along = glm::normalize(path[1] - path[0]);
    return sweep(circle(radius_m, segments), frames_along(path, any_perpendicular(along)));
}

Mesh bolt(float size_m) {
    const float s = size_m;
    const std::array<vec2, 4> washer{
        {{1.15F * s, 0.0F}, {1.15F * s, 0.12F * s}, {1.1F * s, 0.17F * s}, {0.0F, 0.17F * s}}};
    const std::array<vec2, 4> head{{{0.92F * s, 0.15F * s},
                                    {0.92F * s, 0.72F * s},
                                    {0.76F * s, 0.86F * s},
                                    {0.0F, 0.86F * s}}};
    const std::array<vec2, 4> end{
        {{0.5F * s, 0.8F * s}, {0.5F * s, 1.22F * s}, {0.4F * s, 1.32F * s}, {0.0F, 1.34F * s}}};
    Mesh whole = revolve(washer, 14);
    append(whole, revolve(head, 6, 0.3F));
    append(whole, revolve(end, 8));
    return whole;
}

std::vector<glm::mat4> around(int count, float radius_m, float first_rad) {
    std::vector<glm::mat4> places;
    for (int i = 0; i < count; ++i) {
        const float turn =
            first_rad + glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(count);
        places.push_back(about_y(turn) * moved(0.0F, 0.0F, radius_m));
    }
    return places;
}

Mesh extrude(std::span<const vec2> profile, float z0_m, float z1_m, float crease_rad) {
    const std::array<ProfileFrame, 2> frames{ProfileFrame{{0.0F, 0.0F, z0_m}},
                                             ProfileFrame{{0.0F, 0.0F, z1_m}}};
    SweepOptions options;
    options.crease_rad = crease_rad;
    return sweep(profile, frames, options);
}

Mesh rectangle(const vec3& origin_m, const vec3& edge_u_m, const vec3& edge_v_m, float cell_m) {
    PatchOptions options;
    options.size_m = {glm::length(edge_u_m), -glm::length(edge_v_m)};
    options.columns = std::max(1, static_cast<int>(std::ceil(options.size_m.x / cell_m)));
    options.rows = std::max(1, static_cast<int>(std::ceil(-options.size_m.y / cell_m)));
    Mesh mesh =
        patch(options, [&](float u, float v) { return origin_m + edge_u_m * u + edge_v_m * v; });
    for (renderer::Vertex& vertex : mesh.vertices) vertex.tangent.w = -1.0F;
    return mesh;
}

Mesh ring(float radius_m, float thick_m, int around_segments, int section_segments) {
    std::vector<vec3> path;
    for (const vec2& point : circle(radius_m, around_segments))
        path.emplace_back(point.x, 0.0F, point.y);
    SweepOptions options;
    options.closed_path = true;
    return sweep(circle(thick_m, section_segments),
                 frames_along(path, vec3(0.0F, 1.0F, 0.0F), true), options);
}

}  // namespace obscura::stimuli
