// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "tests/stimuli/scenes/mesh_soundness.h"
#include "tests/stimuli/scenes/scene_triangles.h"
#include "tests/stimuli/scenes/seen_soundness.h"

namespace obscura::stimuli {
namespace {

constexpr float kTouch_m = 0.003F;

/// Which piece each triangle of a mesh belongs to: those that share a corner's place are one.
std::vector<std::uint32_t> pieces_of(const Mesh& mesh, std::uint32_t first) {
    const std::vector<std::uint32_t> place_of = places_of(mesh);
    std::vector<std::uint32_t> parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const std::function<std::uint32_t(std::uint32_t)> root = [&](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    const auto root_of_corner = [&](std::size_t i) { return root(place_of[mesh.indices[i]]); };
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        parent[root_of_corner(i + 1)] = root_of_corner(i);
        parent[root_of_corner(i + 2)] = root_of_corner(i);
    }
    std::map<std::uint32_t, std::uint32_t> number;
    std::vector<std::uint32_t> pieces;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto next = first + static_cast<std::uint32_t>(number.size());
        pieces.push_back(number.try_emplace(root_of_corner(i), next).first->second);
    }
    return pieces;
}

/// Marks those pieces that come near another although no ray says so, as where two lie edge to edge
/// in one plane: looks around the corners of both.
void look_around(const Scene& scene, const Triangles& triangles,
                 const std::vector<std::vector<std::uint32_t>>& piece_of,
                 std::vector<char>& touches) {
    const auto for_corners = [&](bool opaque_only,
                                 const std::function<void(std::uint32_t, const glm::vec3&)>& see) {
        for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
            const Mesh& mesh = scene.meshes[m];
            const renderer::Coverage coverage = scene.materials[mesh.material].coverage;
            if (opaque_only && coverage != renderer::Coverage::kOpaque) continue;
            for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
                see(piece_of[m][i / 3], mesh.vertices[mesh.indices[i]].position_m);
            }
        }
    };
    // What most of them lie beside is found around their own corners.
    for_corners(true, [&](std::uint32_t own, const glm::vec3& at) {
        if (touches[own] != 0) return;
        const bool met = triangles.any_near(
            at, kTouch_m, [&](unsigned mesh, unsigned t) { return piece_of[mesh][t] != own; });
        if (met) touches[own] = 1;
    });
    // Of the few that are left, what lies beside the middle of their edges around its corners.
    std::map<std::uint32_t, std::pair<glm::vec3, glm::vec3>> alone;  // with their boxes
    for_corners(true, [&](std::uint32_t own, const glm::vec3& at) {
        if (touches[own] != 0) return;
        auto& [low, high] = alone.try_emplace(own, at, at).first->second;
        low = glm::min(low, at);
        high = glm::max(high, at);
    });
    if (alone.empty()) return;
    for_corners(false, [&](std::uint32_t own, const glm::vec3& at) {
        for (const auto& [piece, box] : alone) {
            const bool outside = glm::any(glm::lessThan(at, box.first - kTouch_m)) ||
                                 glm::any(glm::greaterThan(at, box.second + kTouch_m));
            if (outside || own == piece || touches[piece] != 0) continue;
            const bool met = triangles.any_near(
                at, kTouch_m,
                [&, of = piece](unsigned mesh, unsigned t) { return piece_of[mesh][t] == of; });
            if (met) touches[piece] = 1;
        }
    });
}

/// Of each piece, in cubic metres about its first corner: negative for a cavity, whose faces are
/// turned inwards.
std::vector<double> volumes_of(const Scene& scene,
                               const std::vector<std::vector<std::uint32_t>>& piece_of,
                               std::uint32_t count) {
    std::vector<double> volumes(count, 0.0);
    std::vector<glm::dvec3> origins(count, glm::dvec3(1e30));
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m];
        for (std::size_t t = 0; t < piece_of[m].size(); ++t) {
            const auto corner = [&](std::size_t i) {
                return glm::dvec3(mesh.vertices[mesh.indices[3 * t + i]].position_m);
            };
            glm::dvec3& origin = origins[piece_of[m][t]];
            if (origin.x > 1e29) origin = corner(0);
            volumes[piece_of[m][t]] +=
                glm::dot(corner(0) - origin, glm::cross(corner(1) - origin, corner(2) - origin)) /
                6.0;
        }
    }
    return volumes;
}

}  // namespace

std::vector<std::string> floating_pieces(const Scene& scene) {
    const Triangles triangles(scene);
    std::vector<std::vector<std::uint32_t>> piece_of;  // by mesh and triangle
    std::uint32_t count = 0;
    for (const Mesh& mesh : scene.meshes) {
        piece_of.push_back(pieces_of(mesh, count));
        for (const std::uint32_t piece : piece_of.back()) count = std::max(count, piece + 1);
    }
    std::vector<char> touches(count, 0);
    const auto probe = [&](std::uint32_t own, const glm::vec3& from, const glm::vec3& to) {
        const glm::vec3 way = to - from;
        const float length = glm::length(way);
        if (!(length > 0.0F)) return;
        triangles.each(from, way / length, 0.0F, length, kSolid | kCutOut, [&](const Hit& hit) {
            const std::uint32_t other = piece_of[hit.mesh][hit.triangle];
            if (other == own) return false;
            touches[own] = touches[other] = 1;
            return true;
        });
    };
    Faults faults;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m];
        const renderer::Coverage coverage = scene.materials[mesh.material].coverage;
        if (coverage == renderer::Coverage::kBlended) continue;
        for (std::size_t t = 0; t < piece_of[m].size(); ++t) {
            const std::uint32_t own = piece_of[m][t];
            for (std::size_t k = 0; k < 3 && touches[own] == 0; ++k) {
                const renderer::Vertex& a = mesh.vertices[mesh.indices[3 * t + k]];
                const renderer::Vertex& b = mesh.vertices[mesh.indices[3 * t + (k + 1) % 3]];
                const glm::vec3 way = glm::normalize(b.position_m - a.position_m);
                if (std::isfinite(way.x)) {
                    probe(own, a.position_m - kTouch_m * way, b.position_m + kTouch_m * way);
                }
                probe(own, a.position_m - kTouch_m * a.normal, a.position_m + kTouch_m * a.normal);
            }
        }
    }
    look_around(scene, triangles, piece_of, touches);
    const std::vector<double> volumes = volumes_of(scene, piece_of, count);
    std::vector<char> told(count, 0);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m];
        if (scene.materials[mesh.material].coverage != renderer::Coverage::kOpaque) continue;
        for (std::size_t t = 0; t < piece_of[m].size(); ++t) {
            const std::uint32_t own = piece_of[m][t];
            if (touches[own] != 0 || told[own] != 0 || volumes[own] < 0.0) continue;
            told[own] = 1;
            faults.add(mesh.name + " floats", mesh.vertices[mesh.indices[3 * t]].position_m);
        }
    }
    return faults.lines(/*least=*/1);
}

}  // namespace obscura::stimuli
