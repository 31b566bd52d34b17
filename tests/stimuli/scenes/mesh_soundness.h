// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::stimuli {

/// Indices in range, finite places, unit normals and tangents.
inline void expect_sound(const renderer::Mesh& mesh) {
    SCOPED_TRACE(mesh.name);
    ASSERT_FALSE(mesh.indices.empty());
    ASSERT_EQ(mesh.indices.size() % 3, 0U);
    EXPECT_LT(*std::max_element(mesh.indices.begin(), mesh.indices.end()), mesh.vertices.size());
    std::size_t wrong = 0;
    for (const renderer::Vertex& vertex : mesh.vertices) {
        const glm::vec3 p = vertex.position_m;
        const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
                            std::isfinite(vertex.uv.x) && std::isfinite(vertex.uv.y);
        const bool unit = std::abs(glm::length(vertex.normal) - 1.0F) < 1e-3F &&
                          std::abs(glm::length(glm::vec3(vertex.tangent)) - 1.0F) < 1e-3F;
        if (!finite || !unit) ++wrong;
    }
    EXPECT_EQ(wrong, 0U) << "vertices that are not finite, or whose normal or tangent is not unit";
}

/// Triangles with a vertex normal more than 90 degrees off their face: light and the ray traced
/// truth take such a surface for its own back. A sliver without an area to speak of has no face.
inline std::vector<std::size_t> turned_triangles(const renderer::Mesh& mesh) {
    std::vector<std::size_t> turned;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const renderer::Vertex& a = mesh.vertices[mesh.indices[i]];
        const renderer::Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const renderer::Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        // In double precision: edges of 10 micrometres have little of single precision left.
        const glm::dvec3 p(a.position_m);
        const glm::dvec3 face =
            glm::cross(glm::dvec3(b.position_m) - p, glm::dvec3(c.position_m) - p);
        for (const renderer::Vertex* vertex : {&a, &b, &c}) {
            if (glm::dot(glm::dvec3(vertex->normal), face) < 0.0) {
                turned.push_back(i / 3);
                break;
            }
        }
    }
    return turned;
}

/// A number for each vertex, from 0: the same for those in one place.
inline std::vector<std::uint32_t> places_of(const renderer::Mesh& mesh) {
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto key = [&](std::uint32_t i) {
        const glm::vec3 p = mesh.vertices[i].position_m;
        return std::tuple(p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> place_of(count);
    for (std::uint32_t i = 1; i < count; ++i) {
        place_of[order[i]] =
            place_of[order[i - 1]] + (key(order[i]) == key(order[i - 1]) ? 0U : 1U);
    }
    return place_of;
}

/// Edges, as pairs of places, that one triangle crosses one way and none crosses the other way.
inline std::vector<std::pair<glm::vec3, glm::vec3>> open_edges(const renderer::Mesh& mesh) {
    const std::vector<std::uint32_t> place_of = places_of(mesh);
    std::vector<std::tuple<std::uint32_t, std::uint32_t, int, std::uint32_t, std::uint32_t>> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t a = mesh.indices[i];
        const std::uint32_t b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
        const std::uint32_t low = std::min(place_of[a], place_of[b]);
        const std::uint32_t high = std::max(place_of[a], place_of[b]);
        edges.emplace_back(low, high, place_of[a] < place_of[b] ? 1 : -1, a, b);
    }
    std::sort(edges.begin(), edges.end());
    std::vector<std::pair<glm::vec3, glm::vec3>> open;
    for (std::size_t i = 0; i < edges.size();) {
        const auto [low, high, way, a, b] = edges[i];
        int balance = 0;
        for (; i < edges.size() && std::get<0>(edges[i]) == low && std::get<1>(edges[i]) == high;
             ++i) {
            balance += std::get<2>(edges[i]);
        }
        if (balance != 0) {
            open.emplace_back(mesh.vertices[a].position_m, mesh.vertices[b].position_m);
        }
    }
    return open;
}

/// How often a ray straight up from the point crosses the mesh: odd inside a closed one.
inline int crossings_above(const renderer::Mesh& mesh, const glm::vec3& point) {
    int count = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.vertices[mesh.indices[i]].position_m - point;
        const glm::vec3 b = mesh.vertices[mesh.indices[i + 1]].position_m - point;
        const glm::vec3 c = mesh.vertices[mesh.indices[i + 2]].position_m - point;
        const float u = b.x * c.z - b.z * c.x;
        const float v = c.x * a.z - c.z * a.x;
        const float w = a.x * b.z - a.z * b.x;
        const bool covers = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
        const float sum = u + v + w;
        if (covers && sum != 0.0F && (a.y * u + b.y * v + c.y * w) / sum > 0.0F) ++count;
    }
    return count;
}

inline bool same_mesh(const renderer::Mesh& a, const renderer::Mesh& b) {
    return a.indices == b.indices && a.material == b.material &&
           std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                      [](const renderer::Vertex& x, const renderer::Vertex& y) {
                          return x.position_m == y.position_m && x.normal == y.normal &&
                                 x.tangent == y.tangent && x.uv == y.uv && x.color == y.color;
                      });
}

}  // namespace obscura::stimuli
