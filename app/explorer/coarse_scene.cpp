// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/coarse_scene.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

#include "renderer/light/shadow.h"

namespace obscura::app::explorer {
namespace {

using renderer::Mesh;
using renderer::Vertex;
using Indices = std::vector<std::uint32_t>;

/// Of the scene's diagonal; grown until there are few enough triangles.
constexpr float kFirstError = 2e-5F;
constexpr float kLastError = 0.02F;
/// Leaves are small and apart from each other: an error that smooths a wall removes them.
constexpr float kHolesShare = 0.25F;
/// Corners whose cosine with the surface differs by less are judged by their texture coordinates.
constexpr float kSameSide = 0.05F;

/// A mesh by its places alone: corners that differ in normal or texture coordinates are one, so
/// that an edge between them can go.
struct Places {
    std::vector<glm::vec3> at_m;
    Indices indices;
    Indices first;     ///< of a place's vertices in `vertices`; one more at the end
    Indices vertices;  ///< of the mesh, place by place
};

Places places_of(const Mesh& mesh) {
    std::vector<glm::vec3> at_m;
    at_m.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) at_m.push_back(vertex.position_m);
    Indices place(mesh.vertices.size());
    const std::size_t count = meshopt_generateVertexRemap(
        place.data(), nullptr, mesh.vertices.size(), at_m.data(), at_m.size(), sizeof(glm::vec3));
    Places places;
    places.at_m.resize(count);
    meshopt_remapVertexBuffer(places.at_m.data(), at_m.data(), at_m.size(), sizeof(glm::vec3),
                              place.data());
    places.indices.resize(mesh.indices.size());
    meshopt_remapIndexBuffer(places.indices.data(), mesh.indices.data(), mesh.indices.size(),
                             place.data());
    places.first.assign(count + 1, 0);
    for (const std::uint32_t p : place) ++places.first[p + 1];
    for (std::size_t i = 0; i < count; ++i) places.first[i + 1] += places.first[i];
    places.vertices.resize(place.size());
    Indices next(places.first.begin(), places.first.end() - 1);
    for (std::uint32_t v = 0; v < place.size(); ++v) places.vertices[next[place[v]]++] = v;
    return places;
}

void simplify(Places& places, float error_m) {
    if (places.indices.empty()) return;
    const float size_m =
        meshopt_simplifyScale(&places.at_m[0].x, places.at_m.size(), sizeof(glm::vec3));
    if (!(size_m > 0.0F)) return;
    Indices fewer(places.indices.size());
    fewer.resize(meshopt_simplify(fewer.data(), places.indices.data(), places.indices.size(),
                                  &places.at_m[0].x, places.at_m.size(), sizeof(glm::vec3), 0,
                                  error_m / size_m, 0, nullptr));
    places.indices = std::move(fewer);
}

/// The vertex of a place that a triangle means: the one whose normal is the triangle's, of several
/// the one whose texture coordinates are nearest to those of its first corner.
std::uint32_t corner_of(const Mesh& mesh, const Places& places, std::uint32_t place,
                        const glm::vec3& normal, const Vertex* first) {
    const auto begin = places.vertices.begin() + places.first[place];
    const auto end = places.vertices.begin() + places.first[place + 1];
    const auto faces = [&](std::uint32_t v) { return glm::dot(mesh.vertices[v].normal, normal); };
    const std::uint32_t best = *std::max_element(
        begin, end, [&](std::uint32_t a, std::uint32_t b) { return faces(a) < faces(b); });
    if (first == nullptr) return best;
    const auto off = [&](std::uint32_t v) {
        const bool same_side = faces(v) > faces(best) - kSameSide;
        return same_side ? glm::distance(mesh.vertices[v].uv, first->uv) : 1e30F;
    };
    return *std::min_element(begin, end,
                             [&](std::uint32_t a, std::uint32_t b) { return off(a) < off(b); });
}

/// Few vertices in an order that is quick to draw.
Mesh mesh_of(const Mesh& mesh, const Places& places) {
    Mesh coarse;
    coarse.name = mesh.name;
    coarse.material = mesh.material;
    for (std::size_t i = 0; i + 2 < places.indices.size(); i += 3) {
        const std::uint32_t* const place = &places.indices[i];
        const glm::vec3 normal = glm::cross(places.at_m[place[1]] - places.at_m[place[0]],
                                            places.at_m[place[2]] - places.at_m[place[0]]);
        const float length = glm::length(normal);
        if (!(length > 0.0F)) continue;
        const Vertex* first = nullptr;
        for (int corner = 0; corner < 3; ++corner) {
            coarse.indices.push_back(
                corner_of(mesh, places, place[corner], normal / length, first));
            first = &mesh.vertices[coarse.indices.back()];
        }
    }
    if (coarse.indices.empty()) return coarse;
    meshopt_optimizeVertexCache(coarse.indices.data(), coarse.indices.data(), coarse.indices.size(),
                                mesh.vertices.size());
    coarse.vertices.resize(mesh.vertices.size());
    coarse.vertices.resize(meshopt_optimizeVertexFetch(
        coarse.vertices.data(), coarse.indices.data(), coarse.indices.size(), mesh.vertices.data(),
        mesh.vertices.size(), sizeof(Vertex)));
    coarse.vertices.shrink_to_fit();
    return coarse;
}

[[nodiscard]] std::size_t triangles_of(const std::vector<Places>& all) {
    std::size_t count = 0;
    for (const Places& places : all) count += places.indices.size() / 3;
    return count;
}

}  // namespace

std::optional<CoarseScene> coarser(const renderer::Scene& scene, std::size_t most_triangles,
                                   const std::function<bool()>& go_on) {
    if (scene.triangle_count() <= most_triangles) return std::nullopt;
    const renderer::Bounds bounds = renderer::bounds_of(scene);
    const float diagonal_m = glm::length(bounds.high_m - bounds.low_m);
    if (!std::isfinite(diagonal_m) || !(diagonal_m > 0.0F)) return std::nullopt;
    std::vector<Places> all;
    for (const Mesh& mesh : scene.meshes) {
        all.push_back(places_of(mesh));
        if (!go_on()) return std::nullopt;
    }
    CoarseScene coarse;
    for (float error = kFirstError; error < kLastError; error *= 1.4F) {
        coarse.error_m = error * diagonal_m;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!go_on()) return std::nullopt;
            const bool holes =
                scene.materials[scene.meshes[i].material].coverage != renderer::Coverage::kOpaque;
            simplify(all[i], (holes ? kHolesShare : 1.0F) * coarse.error_m);
        }
        if (triangles_of(all) <= most_triangles) break;
    }
    coarse.scene.name = scene.name;
    coarse.scene.materials = scene.materials;
    coarse.scene.cameras = scene.cameras;
    for (const renderer::Texture& texture : scene.textures) {
        coarse.scene.textures.push_back(
            {texture.name, texture.width, texture.height, texture.srgb, {}});
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        Mesh mesh = mesh_of(scene.meshes[i], all[i]);
        if (!mesh.indices.empty()) coarse.scene.meshes.push_back(std::move(mesh));
    }
    return coarse;
}

}  // namespace obscura::app::explorer
