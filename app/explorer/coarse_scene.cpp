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
/// Cosine between triangles that one surface is bent from, not broken: 45 degrees.
constexpr float kLittleBend = 0.7071F;
/// Of a side's length in the texture: a corner that is further off belongs to another piece of it.
constexpr float kMostStretch = 0.5F;

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

/// How the texture lies about a vertex: change of its coordinates a metre, along the surface.
struct Lie {
    glm::vec3 u{0.0F};
    glm::vec3 v{0.0F};
    float area_m2 = 0.0F;  ///< of the triangle that it was taken from

    [[nodiscard]] glm::vec2 over(const glm::vec3& way_m) const {
        return {glm::dot(u, way_m), glm::dot(v, way_m)};
    }
};

/// For each vertex that of the largest triangle about it.
std::vector<Lie> lies_of(const Mesh& mesh) {
    std::vector<Lie> lies(mesh.vertices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 ab = b.position_m - a.position_m;
        const glm::vec3 ac = c.position_m - a.position_m;
        const glm::vec3 across = glm::cross(ab, ac);
        const float size = glm::dot(across, across);
        if (!(size > 0.0F)) continue;
        const glm::vec3 along_ab = glm::cross(ac, across) / size;
        const glm::vec3 along_ac = glm::cross(across, ab) / size;
        const glm::vec2 by_b = b.uv - a.uv;
        const glm::vec2 by_c = c.uv - a.uv;
        const Lie lie{by_b.x * along_ab + by_c.x * along_ac, by_b.y * along_ab + by_c.y * along_ac,
                      0.5F * std::sqrt(size)};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Lie& of = lies[mesh.indices[i + corner]];
            if (lie.area_m2 > of.area_m2) of = lie;
        }
    }
    return lies;
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

/// Twice the area of each triangle, as a vector along its normal.
std::vector<glm::vec3> faces_of(const Places& places) {
    std::vector<glm::vec3> faces;
    faces.reserve(places.indices.size() / 3);
    for (std::size_t i = 0; i + 2 < places.indices.size(); i += 3) {
        const glm::vec3& at = places.at_m[places.indices[i]];
        faces.push_back(glm::cross(places.at_m[places.indices[i + 1]] - at,
                                   places.at_m[places.indices[i + 2]] - at));
    }
    return faces;
}

[[nodiscard]] glm::vec3 unit(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0F ? v / length : glm::vec3(0.0F);
}

/// The normal of each triangle's each corner: the mean of the triangles about its place that bend
/// but little from it. What the many triangles had, a chamfer's or a groove's, would be spread over
/// all of a large one.
std::vector<glm::vec3> normals_of(const Places& places, const std::vector<glm::vec3>& faces) {
    Indices first(places.at_m.size() + 1, 0);
    for (const std::uint32_t place : places.indices) ++first[place + 1];
    for (std::size_t i = 0; i + 1 < first.size(); ++i) first[i + 1] += first[i];
    Indices about(places.indices.size());
    Indices next(first.begin(), first.end() - 1);
    for (std::uint32_t i = 0; i < places.indices.size(); ++i) {
        about[next[places.indices[i]]++] = i / 3;
    }
    std::vector<glm::vec3> normals(places.indices.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::vec3 own = unit(faces[i / 3]);
        glm::vec3 sum(0.0F);
        for (std::uint32_t k = first[places.indices[i]]; k < first[places.indices[i] + 1]; ++k) {
            const glm::vec3& face = faces[about[k]];
            if (glm::dot(own, face) > kLittleBend * glm::length(face)) sum += face;
        }
        normals[i] = unit(sum);
    }
    return normals;
}

/// Vertices that are alike as one, in an order that is quick to draw.
void weld(Mesh& mesh) {
    Indices remap(mesh.indices.size());
    const std::size_t count =
        meshopt_generateVertexRemap(remap.data(), nullptr, mesh.indices.size(),
                                    mesh.vertices.data(), mesh.vertices.size(), sizeof(Vertex));
    meshopt_remapVertexBuffer(mesh.vertices.data(), mesh.vertices.data(), mesh.vertices.size(),
                              sizeof(Vertex), remap.data());
    mesh.vertices.resize(count);
    mesh.vertices.shrink_to_fit();
    mesh.indices = std::move(remap);
    meshopt_optimizeVertexCache(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(),
                                count);
    meshopt_optimizeVertexFetch(mesh.vertices.data(), mesh.indices.data(), mesh.indices.size(),
                                mesh.vertices.data(), count, sizeof(Vertex));
}

/// The triangles that are left, with vertices made of those that were there.
Mesh mesh_of(const Mesh& mesh, const Places& places, bool holes) {
    Mesh coarse;
    coarse.name = mesh.name;
    coarse.material = mesh.material;
    const std::vector<glm::vec3> faces = faces_of(places);
    const std::vector<glm::vec3> normals = normals_of(places, faces);
    const std::vector<Lie> lies = lies_of(mesh);
    for (std::size_t i = 0; i + 2 < places.indices.size(); i += 3) {
        const glm::vec3 normal = unit(faces[i / 3]);
        if (normal == glm::vec3(0.0F)) continue;
        const std::uint32_t first = corner_of(mesh, places, places.indices[i], normal, nullptr);
        const Vertex& of = mesh.vertices[first];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t place = places.indices[i + corner];
            Vertex vertex =
                mesh.vertices[corner == 0 ? first : corner_of(mesh, places, place, normal, &of)];
            // From another piece of the texture: the first corner's is continued.
            const glm::vec2 expected =
                of.uv + lies[first].over(places.at_m[place] - places.at_m[places.indices[i]]);
            const float way = glm::distance(expected, of.uv);
            if (glm::distance(vertex.uv, expected) > kMostStretch * way) vertex.uv = expected;
            // Leaves have normals of their own making.
            if (!holes) {
                vertex.normal = normals[i + corner];
                const glm::vec3 along =
                    unit(glm::vec3(vertex.tangent) -
                         glm::dot(glm::vec3(vertex.tangent), vertex.normal) * vertex.normal);
                if (along != glm::vec3(0.0F)) vertex.tangent = {along, vertex.tangent.w};
            }
            coarse.indices.push_back(static_cast<std::uint32_t>(coarse.vertices.size()));
            coarse.vertices.push_back(vertex);
        }
    }
    if (!coarse.indices.empty()) weld(coarse);
    return coarse;
}

[[nodiscard]] bool has_holes(const renderer::Scene& scene, const Mesh& mesh) {
    return scene.materials[mesh.material].coverage != renderer::Coverage::kOpaque;
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
            const bool holes = has_holes(scene, scene.meshes[i]);
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
        if (!go_on()) return std::nullopt;
        Mesh mesh = mesh_of(scene.meshes[i], all[i], has_holes(scene, scene.meshes[i]));
        if (!mesh.indices.empty()) coarse.scene.meshes.push_back(std::move(mesh));
    }
    return coarse;
}

}  // namespace obscura::app::explorer
