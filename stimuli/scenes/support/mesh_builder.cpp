// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/support/mesh_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/constants.hpp>

namespace obscura::stimuli {
namespace {

using renderer::Mesh;
using renderer::Vertex;
using Index = std::uint32_t;

void add_quad(Mesh& mesh, Index a, Index b, Index c, Index d) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
}

/// Difference of positions around one parameter, inside [0, 1] unless it wraps there.
template <typename Position>
glm::vec3 difference(const Position& position, float at, float step, bool closed) {
    float low = at - step;
    float high = at + step;
    if (!closed) {
        low = std::max(low, 0.0F);
        high = std::min(high, 1.0F);
    }
    const auto wrapped = [&](float t) { return closed ? t - std::floor(t) : t; };
    return (position(wrapped(high)) - position(wrapped(low))) / (high - low);
}

Vertex patch_vertex(const PatchOptions& options,
                    const std::function<glm::vec3(float, float)>& position, float u, float v) {
    const float du = 0.25F / static_cast<float>(options.columns);
    const float dv = 0.25F / static_cast<float>(options.rows);
    Vertex vertex;
    vertex.position_m = position(u, v);
    vertex.uv = glm::vec2(u, v) * options.size_m;
    glm::vec3 along_u(0.0F);
    glm::vec3 normal(0.0F);
    // Where the patch comes to a point, the normal of a place nearby holds.
    for (const float inwards : {0.0F, 0.5F, 1.0F}) {
        const float nearby_u = u + (0.5F - u) * 2.0F * du * inwards;
        const float nearby_v = v + (0.5F - v) * 2.0F * dv * inwards;
        along_u = difference([&](float t) { return position(t, nearby_v); }, nearby_u, du,
                             options.closed_u);
        const glm::vec3 along_v = difference([&](float t) { return position(nearby_u, t); },
                                             nearby_v, dv, options.closed_v);
        normal = glm::cross(along_u, along_v);
        const float longest = std::max(glm::length(along_u), glm::length(along_v));
        if (glm::length(normal) > 1e-4F * longest * longest) break;
    }
    vertex.normal =
        glm::length(normal) > 1e-9F ? glm::normalize(normal) : glm::vec3(0.0F, 1.0F, 0.0F);
    const glm::vec3 flat = along_u - vertex.normal * glm::dot(along_u, vertex.normal);
    const glm::vec3 tangent =
        glm::length(flat) > 1e-9F ? glm::normalize(flat) : any_perpendicular(vertex.normal);
    vertex.tangent = glm::vec4(tangent, 1.0F);
    return vertex;
}

/// A row of vertices that comes to a point but for rounding comes to the same place to the last
/// bit.
void bring_to_a_point(Mesh& mesh, Index first, Index last) {
    constexpr float kRounding_m = 1e-6F;
    const glm::vec3 place = mesh.vertices[first].position_m;
    for (Index i = first; i <= last; ++i) {
        if (glm::distance(mesh.vertices[i].position_m, place) > kRounding_m) return;
    }
    for (Index i = first; i <= last; ++i) mesh.vertices[i].position_m = place;
}

/// Length along a polyline up to each of its points.
template <typename Point>
std::vector<float> lengths_along(std::span<const Point> points, bool closed) {
    std::vector<float> lengths{0.0F};
    const std::size_t steps = closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < steps; ++i) {
        const Point& next = points[(i + 1) % points.size()];
        lengths.push_back(lengths.back() + glm::length(next - points[i]));
    }
    return lengths;
}

glm::vec3 in_frame(const ProfileFrame& frame, const glm::vec2& point) {
    return frame.origin_m + frame.x_axis * point.x + frame.y_axis * point.y;
}

void add_cap(Mesh& mesh, std::span<const glm::vec2> profile, const ProfileFrame& frame,
             bool at_start) {
    const auto first = static_cast<Index>(mesh.vertices.size());
    glm::vec2 mean(0.0F);
    for (const glm::vec2& point : profile) mean += point / static_cast<float>(profile.size());
    const auto add = [&](const glm::vec2& point) {
        Vertex vertex;
        vertex.position_m = in_frame(frame, point);
        vertex.uv = point;
        mesh.vertices.push_back(vertex);
    };
    add(mean);
    for (const glm::vec2& point : profile) add(point);
    const auto count = static_cast<Index>(profile.size());
    for (Index i = 0; i < count; ++i) {
        const Index a = first + 1 + i;
        const Index b = first + 1 + (i + 1) % count;
        if (at_start) {
            mesh.indices.insert(mesh.indices.end(), {first, b, a});
        } else {
            mesh.indices.insert(mesh.indices.end(), {first, a, b});
        }
    }
}

}  // namespace

Mesh patch(const PatchOptions& options, const std::function<glm::vec3(float, float)>& position) {
    Mesh mesh;
    const int columns = options.columns;
    const int rows = options.rows;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            mesh.vertices.push_back(
                patch_vertex(options, position, static_cast<float>(i) / static_cast<float>(columns),
                             static_cast<float>(j) / static_cast<float>(rows)));
        }
    }
    const auto at = [&](int i, int j) { return static_cast<Index>(j * (columns + 1) + i); };
    bring_to_a_point(mesh, at(0, 0), at(columns, 0));
    bring_to_a_point(mesh, at(0, rows), at(columns, rows));
    const auto add = [&](Index a, Index b, Index c) {
        const auto place = [&](Index k) { return mesh.vertices[k].position_m; };
        if (place(a) == place(b) || place(b) == place(c) || place(c) == place(a)) return;
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return mesh;
}

Mesh bevelled_box(glm::vec3 size_m, float bevel_m) {
    Mesh mesh;
    const glm::vec3 half = size_m * 0.5F;
    const float bevel = std::min(bevel_m, 0.49F * std::min({size_m.x, size_m.y, size_m.z}));
    // Corner k of the box, moved inwards on the two axes other than `axis`, with that face's
    // normal.
    const auto corner = [&](int k, int axis) {
        const glm::vec3 sign((k & 1) != 0 ? 1.0F : -1.0F, (k & 2) != 0 ? 1.0F : -1.0F,
                             (k & 4) != 0 ? 1.0F : -1.0F);
        Vertex vertex;
        vertex.position_m = sign * (half - bevel);
        vertex.position_m[axis] = sign[axis] * half[axis];
        vertex.normal = glm::vec3(0.0F);
        vertex.normal[axis] = sign[axis];
        return vertex;
    };
    for (int k = 0; k < 8; ++k) {
        for (int axis = 0; axis < 3; ++axis) mesh.vertices.push_back(corner(k, axis));
    }
    const auto at = [](int k, int axis) { return static_cast<Index>(3 * k + axis); };
    // Adds a triangle so that it faces away from the middle of the box.
    const auto add = [&](Index a, Index b, Index c) {
        const glm::vec3& p = mesh.vertices[a].position_m;
        const glm::vec3 normal =
            glm::cross(mesh.vertices[b].position_m - p, mesh.vertices[c].position_m - p);
        const bool outwards = glm::dot(normal, p) > 0.0F;
        mesh.indices.insert(mesh.indices.end(), {a, outwards ? b : c, outwards ? c : b});
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int one = 1 << ((axis + 1) % 3);
        const int two = 1 << ((axis + 2) % 3);
        for (const int side : {0, 1 << axis}) {
            add(at(side, axis), at(side + one, axis), at(side + one + two, axis));
            add(at(side, axis), at(side + one + two, axis), at(side + two, axis));
        }
    }
    for (int along = 0; along < 3 && bevel > 0.0F; ++along) {
        const int p = (along + 1) % 3;
        const int q = (along + 2) % 3;
        for (const int edge : {0, 1 << p, 1 << q, (1 << p) + (1 << q)}) {
            const int far_end = edge + (1 << along);
            add(at(edge, p), at(far_end, p), at(far_end, q));
            add(at(edge, p), at(far_end, q), at(edge, q));
        }
    }
    for (int k = 0; k < 8 && bevel > 0.0F; ++k) add(at(k, 0), at(k, 1), at(k, 2));
    project_box_uv(mesh);
    return mesh;
}

Mesh revolve(std::span<const glm::vec2> profile, int segments, float crease_rad) {
    Mesh mesh;
    const std::vector<float> lengths = lengths_along(profile, false);
    float widest = 0.0F;
    for (const glm::vec2& point : profile) widest = std::max(widest, point.x);
    for (std::size_t j = 0; j < profile.size(); ++j) {
        for (int i = 0; i <= segments; ++i) {
            const float turn = static_cast<float>(i) / static_cast<float>(segments);
            // The seam's two ends must be the same place to the last bit.
            const float angle = i == segments ? 0.0F : turn * glm::two_pi<float>();
            Vertex vertex;
            vertex.position_m = {profile[j].x * std::sin(angle), profile[j].y,
                                 profile[j].x * std::cos(angle)};
            vertex.uv = {turn * glm::two_pi<float>() * widest, lengths.back() - lengths[j]};
            mesh.vertices.push_back(vertex);
        }
    }
    const auto at = [&](std::size_t j, int i) {
        return static_cast<Index>(j) * static_cast<Index>(segments + 1) + static_cast<Index>(i);
    };
    for (std::size_t j = 0; j + 1 < profile.size(); ++j) {
        for (int i = 0; i < segments; ++i) {
            add_quad(mesh, at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i));
        }
    }
    smooth_normals(mesh, crease_rad);
    return mesh;
}

Mesh sweep(std::span<const glm::vec2> profile, std::span<const ProfileFrame> frames,
           const SweepOptions& options) {
    Mesh mesh;
    std::vector<glm::vec3> places;
    for (const ProfileFrame& frame : frames) places.push_back(frame.origin_m);
    const std::vector<float> along =
        lengths_along(std::span<const glm::vec3>(places), options.closed_path);
    const std::vector<float> around = lengths_along(profile, options.closed_profile);
    for (std::size_t j = 0; j < along.size(); ++j) {
        for (std::size_t i = 0; i < around.size(); ++i) {
            Vertex vertex;
            vertex.position_m = in_frame(frames[j % frames.size()], profile[i % profile.size()]);
            vertex.uv = {along[j], around[i]};
            mesh.vertices.push_back(vertex);
        }
    }
    const auto at = [&](std::size_t j, std::size_t i) {
        return static_cast<Index>(j * around.size() + i);
    };
    for (std::size_t j = 0; j + 1 < along.size(); ++j) {
        for (std::size_t i = 0; i + 1 < around.size(); ++i) {
            add_quad(mesh, at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i));
        }
    }
    if (options.caps && options.closed_profile && !options.closed_path) {
        add_cap(mesh, profile, frames.front(), true);
        add_cap(mesh, profile, frames.back(), false);
    }
    smooth_normals(mesh, options.crease_rad);
    return mesh;
}

std::vector<ProfileFrame> frames_along(std::span<const glm::vec3> path_m, glm::vec3 up,
                                       bool closed) {
    std::vector<ProfileFrame> frames;
    const std::size_t count = path_m.size();
    glm::vec3 last_y = up;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t before = i > 0 ? i - 1 : (closed ? count - 1 : 0);
        const std::size_t after = i + 1 < count ? i + 1 : (closed ? 0 : count - 1);
        const glm::vec3 incoming =
            before != i ? glm::normalize(path_m[i] - path_m[before]) : glm::vec3(0.0F);
        const glm::vec3 outgoing =
            after != i ? glm::normalize(path_m[after] - path_m[i]) : glm::vec3(0.0F);
        const glm::vec3 along = glm::normalize(incoming + outgoing);
        glm::vec3 y = last_y - along * glm::dot(last_y, along);
        y = glm::length(y) > 1e-4F ? glm::normalize(y) : any_perpendicular(along);
        frames.push_back({path_m[i], glm::cross(y, along), y});
        last_y = y;
    }
    return frames;
}

std::vector<glm::vec2> circle(float radius_m, int segments) {
    std::vector<glm::vec2> points;
    for (int i = 0; i < segments; ++i) {
        const float angle =
            glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(segments);
        points.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle));
    }
    return points;
}

}  // namespace obscura::stimuli
