// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "stimuli/scenes/support/mesh_builder.h"

namespace obscura::stimuli {
namespace {

using renderer::Mesh;
using renderer::Vertex;

struct PlaceHash {
    std::size_t operator()(const glm::i64vec3& place) const {
        const auto x = static_cast<std::uint64_t>(place.x) * 0x9e3779b97f4a7c15ULL;
        const auto y = static_cast<std::uint64_t>(place.y) * 0xbf58476d1ce4e5b9ULL;
        const auto z = static_cast<std::uint64_t>(place.z) * 0x94d049bb133111ebULL;
        const std::uint64_t mixed = x ^ (y >> 7) ^ (y << 19) ^ (z >> 13) ^ (z << 31);
        return static_cast<std::size_t>(mixed ^ (mixed >> 29));
    }
};

glm::i64vec3 place_of(const glm::vec3& position_m) {
    return glm::i64vec3(glm::round(glm::dvec3(position_m) * 1e5));  // 10 micrometres
}

/// Twice the area along the normal.
glm::vec3 area_vector(const Mesh& mesh, std::size_t triangle) {
    const glm::vec3& a = mesh.vertices[mesh.indices[3 * triangle]].position_m;
    const glm::vec3& b = mesh.vertices[mesh.indices[3 * triangle + 1]].position_m;
    const glm::vec3& c = mesh.vertices[mesh.indices[3 * triangle + 2]].position_m;
    return glm::cross(b - a, c - a);
}

glm::u8vec4 scaled(const glm::u8vec4& color, const glm::vec3& factor) {
    const glm::vec3 product = glm::clamp(glm::vec3(color) * factor + 0.5F, 0.0F, 255.0F);
    return {static_cast<std::uint8_t>(product.x), static_cast<std::uint8_t>(product.y),
            static_cast<std::uint8_t>(product.z), color.w};
}

void remove_empty_triangles(Mesh& mesh) {
    std::vector<std::uint32_t> kept;
    kept.reserve(mesh.indices.size());
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        if (glm::length(area_vector(mesh, t)) < 1e-10F) continue;
        for (std::size_t k = 0; k < 3; ++k) kept.push_back(mesh.indices[3 * t + k]);
    }
    mesh.indices = std::move(kept);
}

}  // namespace

glm::vec3 any_perpendicular(const glm::vec3& direction) {
    const glm::vec3 other =
        std::abs(direction.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
    return glm::normalize(glm::cross(other, direction));
}

void append(Mesh& whole, const Mesh& part, const Placement& placement) {
    const auto first = static_cast<std::uint32_t>(whole.vertices.size());
    const glm::mat3 linear(placement.transform);
    const glm::mat3 for_normals = glm::transpose(glm::inverse(linear));
    const bool mirrored = glm::determinant(linear) < 0.0F;
    const float uv_turn = placement.uv_scale.x * placement.uv_scale.y < 0.0F ? -1.0F : 1.0F;
    const float along_u = placement.uv_scale.x < 0.0F ? -1.0F : 1.0F;
    for (const Vertex& source : part.vertices) {
        Vertex vertex = source;
        vertex.position_m = glm::vec3(placement.transform * glm::vec4(source.position_m, 1.0F));
        vertex.normal = glm::normalize(for_normals * source.normal);
        const glm::vec3 tangent = linear * glm::vec3(source.tangent) * along_u;
        const glm::vec3 flat = tangent - vertex.normal * glm::dot(tangent, vertex.normal);
        vertex.tangent =
            glm::vec4(glm::normalize(flat), source.tangent.w * uv_turn * (mirrored ? -1.0F : 1.0F));
        vertex.uv = source.uv * placement.uv_scale + placement.uv_offset;
        vertex.color = scaled(source.color, placement.tint);
        whole.vertices.push_back(vertex);
    }
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
        whole.indices.push_back(first + part.indices[i]);
        whole.indices.push_back(first + part.indices[i + (mirrored ? 2 : 1)]);
        whole.indices.push_back(first + part.indices[i + (mirrored ? 1 : 2)]);
    }
}

void paint(Mesh& mesh, const std::function<glm::vec3(const glm::vec3&, const glm::vec3&)>& colour) {
    for (Vertex& vertex : mesh.vertices) {
        vertex.color = scaled(vertex.color, colour(vertex.position_m, vertex.normal));
    }
}

void project_box_uv(Mesh& mesh) {
    Mesh split;
    split.indices.reserve(mesh.indices.size());
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const glm::vec3 normal = area_vector(mesh, t);
        const glm::vec3 size = glm::abs(normal);
        const int axis = size.y >= size.x && size.y >= size.z ? 1 : (size.x >= size.z ? 0 : 2);
        const int side = 2 * axis + (normal[axis] < 0.0F ? 1 : 0);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t old = mesh.indices[3 * t + k];
            const std::uint64_t key = 6ULL * old + static_cast<std::uint64_t>(side);
            const auto [entry, fresh] =
                known.try_emplace(key, static_cast<std::uint32_t>(split.vertices.size()));
            if (fresh) {
                Vertex vertex = mesh.vertices[old];
                const glm::vec3& p = vertex.position_m;
                const std::array<glm::vec2, 6> uv{glm::vec2(-p.z, -p.y), glm::vec2(p.z, -p.y),
                                                  glm::vec2(p.x, p.z),   glm::vec2(p.x, -p.z),
                                                  glm::vec2(p.x, -p.y),  glm::vec2(-p.x, -p.y)};
                vertex.uv = uv[static_cast<std::size_t>(side)];
                split.vertices.push_back(vertex);
            }
            split.indices.push_back(entry->second);
        }
    }
    mesh.vertices = std::move(split.vertices);
    mesh.indices = std::move(split.indices);
    make_tangents(mesh);
}

void smooth_normals(Mesh& mesh, float crease_rad) {
    remove_empty_triangles(mesh);
    const std::size_t corners = mesh.indices.size();
    std::unordered_map<glm::i64vec3, std::vector<std::uint32_t>, PlaceHash> meeting;
    std::vector<glm::vec3> areas(corners / 3);
    for (std::size_t t = 0; t < areas.size(); ++t) areas[t] = area_vector(mesh, t);
    for (std::size_t c = 0; c < corners; ++c) {
        meeting[place_of(mesh.vertices[mesh.indices[c]].position_m)].push_back(
            static_cast<std::uint32_t>(c / 3));
    }
    const float crease_cos = std::cos(crease_rad);
    Mesh split;
    split.indices.reserve(corners);
    std::unordered_multimap<std::uint32_t, std::uint32_t> made;
    for (std::size_t c = 0; c < corners; ++c) {
        const std::uint32_t old = mesh.indices[c];
        Vertex vertex = mesh.vertices[old];
        const glm::vec3 own = glm::normalize(areas[c / 3]);
        glm::vec3 sum(0.0F);
        for (const std::uint32_t t : meeting[place_of(vertex.position_m)]) {
            if (glm::dot(own, glm::normalize(areas[t])) >= crease_cos) sum += areas[t];
        }
        vertex.normal = glm::length(sum) > 0.0F ? glm::normalize(sum) : own;
        std::uint32_t index = static_cast<std::uint32_t>(split.vertices.size());
        const auto [begin, end] = made.equal_range(old);
        for (auto entry = begin; entry != end; ++entry) {
            const glm::vec3& other = split.vertices[entry->second].normal;
            if (glm::dot(other, vertex.normal) > 0.9999F) index = entry->second;
        }
        if (index == split.vertices.size()) {
            split.vertices.push_back(vertex);
            made.emplace(old, index);
        }
        split.indices.push_back(index);
    }
    mesh.vertices = std::move(split.vertices);
    mesh.indices = std::move(split.indices);
    make_tangents(mesh);
}

namespace {

/// Twice the area along the normal. In double precision, since a sliver's sides of micrometres have
/// little left of single precision.
glm::dvec3 exact_area_vector(const Mesh& mesh, std::size_t triangle) {
    const glm::dvec3 a(mesh.vertices[mesh.indices[3 * triangle]].position_m);
    const glm::dvec3 b(mesh.vertices[mesh.indices[3 * triangle + 1]].position_m);
    const glm::dvec3 c(mesh.vertices[mesh.indices[3 * triangle + 2]].position_m);
    return glm::cross(b - a, c - a);
}

void set_normal(Vertex& vertex, const glm::dvec3& normal) {
    vertex.normal = glm::vec3(normal);
    const glm::vec3 along(vertex.tangent);
    const glm::vec3 flat = along - vertex.normal * glm::dot(vertex.normal, along);
    const float length = glm::length(flat);
    const glm::vec3 tangent = length > 1e-3F ? flat / length : any_perpendicular(vertex.normal);
    vertex.tangent = glm::vec4(tangent, vertex.tangent.w);
}

/// The vertices that a face of theirs turns its back on.
std::vector<bool> turned_vertices(const Mesh& mesh) {
    std::vector<bool> turned(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t at = mesh.indices[i];
        const glm::dvec3 face = exact_area_vector(mesh, i / 3);
        if (glm::dot(glm::dvec3(mesh.vertices[at].normal), face) < 0.0) turned[at] = true;
    }
    return turned;
}

}  // namespace

void turn_normals_outwards(Mesh& mesh) {
    const std::vector<bool> turned = turned_vertices(mesh);
    if (std::find(turned.begin(), turned.end(), true) == turned.end()) return;
    std::unordered_map<std::uint32_t, glm::dvec3> mean;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (!turned[mesh.indices[i]]) continue;
        mean.try_emplace(mesh.indices[i], 0.0).first->second += exact_area_vector(mesh, i / 3);
    }
    for (const auto& [at, sum] : mean) {
        if (glm::length(sum) > 0.0) set_normal(mesh.vertices[at], glm::normalize(sum));
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (!turned[mesh.indices[i]]) continue;
        const glm::dvec3 face = exact_area_vector(mesh, i / 3);
        Vertex own = mesh.vertices[mesh.indices[i]];
        if (!(glm::dot(glm::dvec3(own.normal), face) < 0.0)) continue;
        set_normal(own, glm::normalize(face));
        mesh.indices[i] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(own);
    }
}

void make_tangents(Mesh& mesh) {
    std::vector<glm::vec3> along_u(mesh.vertices.size(), glm::vec3(0.0F));
    std::vector<glm::vec3> along_v(mesh.vertices.size(), glm::vec3(0.0F));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 e = b.position_m - a.position_m;
        const glm::vec3 f = c.position_m - a.position_m;
        const glm::vec2 p = b.uv - a.uv;
        const glm::vec2 q = c.uv - a.uv;
        const float turn = p.x * q.y - q.x * p.y < 0.0F ? -1.0F : 1.0F;
        const glm::vec3 u = (e * q.y - f * p.y) * turn;
        const glm::vec3 v = (f * p.x - e * q.x) * turn;
        for (std::size_t k = 0; k < 3; ++k) {
            along_u[mesh.indices[i + k]] += u;
            along_v[mesh.indices[i + k]] += v;
        }
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        Vertex& vertex = mesh.vertices[i];
        const glm::vec3 flat = along_u[i] - vertex.normal * glm::dot(vertex.normal, along_u[i]);
        const float length = glm::length(flat);
        const glm::vec3 tangent =
            length > 1e-12F ? flat / length : any_perpendicular(vertex.normal);
        const bool left = glm::dot(glm::cross(vertex.normal, tangent), along_v[i]) < 0.0F;
        vertex.tangent = glm::vec4(tangent, left ? -1.0F : 1.0F);
    }
}

}  // namespace obscura::stimuli
