// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/mesh_finish.h"

#include <cmath>
#include <utility>
#include <vector>

namespace obscura::renderer::import_detail {
namespace {

using glm::dvec3;

/// Normal times twice the area; double, since coordinates may be large.
dvec3 area_vector(const Mesh& mesh, std::size_t first) {
    const dvec3 a = mesh.vertices[mesh.indices[first]].position_m;
    const dvec3 b = mesh.vertices[mesh.indices[first + 1]].position_m;
    const dvec3 c = mesh.vertices[mesh.indices[first + 2]].position_m;
    return glm::cross(b - a, c - a);
}

glm::vec3 unit_or(const dvec3& v, const glm::vec3& otherwise) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : otherwise;
}

glm::vec3 any_perpendicular(const glm::vec3& n) {
    const glm::vec3 axis =
        std::abs(n.x) < 0.6F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
    return glm::normalize(axis - n * glm::dot(axis, n));
}

/// Directions of growing u and v over a triangle, and whether its mapping is mirrored.
struct Mapping {
    dvec3 along_u{0.0};
    bool mirrored = false;
};

Mapping mapping_of(const Mesh& mesh, std::size_t first) {
    const Vertex& a = mesh.vertices[mesh.indices[first]];
    const Vertex& b = mesh.vertices[mesh.indices[first + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[first + 2]];
    const dvec3 e = dvec3(b.position_m) - dvec3(a.position_m);
    const dvec3 f = dvec3(c.position_m) - dvec3(a.position_m);
    const glm::dvec2 p = glm::dvec2(b.uv) - glm::dvec2(a.uv);
    const glm::dvec2 q = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    const double turn = p.x * q.y - q.x * p.y;
    Mapping mapping;
    mapping.along_u = (e * q.y - f * p.y) * (turn < 0.0 ? -1.0 : 1.0);
    // v runs down in the image: a triangle that is counter-clockwise there has turn < 0.
    mapping.mirrored = turn > 0.0;
    const double length = glm::length(mapping.along_u);
    const double area = glm::length(glm::cross(e, f));
    mapping.along_u = length > 0.0 && turn != 0.0 ? mapping.along_u * (area / length) : dvec3(0.0);
    return mapping;
}

/// Gives vertices that are used by mirrored and unmirrored triangles a second copy for the former.
std::vector<bool> split_mirrored(Mesh& mesh, const std::vector<Mapping>& mappings) {
    constexpr std::uint32_t kNone = ~0U;
    std::vector<char> seen(mesh.vertices.size(), 0);  // 1: unmirrored, 2: mirrored
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        seen[mesh.indices[i]] |= mappings[i / 3].mirrored ? 2 : 1;
    }
    std::vector<bool> mirrored(mesh.vertices.size());
    std::vector<std::uint32_t> copy(mesh.vertices.size(), kNone);
    for (std::size_t v = 0; v < seen.size(); ++v) mirrored[v] = seen[v] == 2;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t old = mesh.indices[i];
        if (seen[old] != 3 || !mappings[i / 3].mirrored) continue;
        if (copy[old] == kNone) {
            copy[old] = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(Vertex(mesh.vertices[old]));
            mirrored.push_back(true);
        }
        mesh.indices[i] = copy[old];
    }
    return mirrored;
}

}  // namespace

void make_flat_normals(Mesh& mesh) {
    std::vector<Vertex> corners;
    corners.reserve(mesh.indices.size());
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const glm::vec3 normal = unit_or(area_vector(mesh, first), {0.0F, 1.0F, 0.0F});
        for (std::size_t k = 0; k < 3; ++k) {
            corners.push_back(mesh.vertices[mesh.indices[first + k]]);
            corners.back().normal = normal;
        }
    }
    mesh.vertices = std::move(corners);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        mesh.indices[i] = static_cast<std::uint32_t>(i);
    }
}

std::size_t mend_normals(Mesh& mesh) {
    std::vector<dvec3> sums;
    std::size_t mended = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        glm::vec3& normal = mesh.vertices[v].normal;
        const float length = glm::length(normal);
        if (length > 1e-6F && std::isfinite(length)) {
            if (std::abs(length - 1.0F) > 1e-3F) normal /= length;
            continue;
        }
        if (sums.empty()) {
            sums.assign(mesh.vertices.size(), dvec3(0.0));
            for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
                sums[mesh.indices[i]] += area_vector(mesh, i / 3 * 3);
            }
        }
        normal = unit_or(sums[v], {0.0F, 1.0F, 0.0F});
        ++mended;
    }
    return mended;
}

Sides sides_of(const Mesh& mesh) {
    constexpr double kRounding = 1e-6;  // of normals in single precision
    Sides sides;
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const dvec3 area = area_vector(mesh, first);
        const double size = glm::length(area);
        if (!(size > 0.0)) continue;
        ++sides.with_area;
        bool turned = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec3 normal = mesh.vertices[mesh.indices[first + k]].normal;
            turned = turned || glm::dot(area, normal) < -kRounding * size;
        }
        if (turned) ++sides.with_turned_normal;
    }
    return sides;
}

std::size_t turn_to_normals(Mesh& mesh) {
    std::size_t turned = 0;
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        dvec3 normal(0.0);
        for (std::size_t k = 0; k < 3; ++k) normal += mesh.vertices[mesh.indices[first + k]].normal;
        if (!(glm::dot(area_vector(mesh, first), normal) < 0.0)) continue;
        std::swap(mesh.indices[first + 1], mesh.indices[first + 2]);
        ++turned;
    }
    return turned;
}

void make_tangents(Mesh& mesh) {
    std::vector<Mapping> mappings;
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        mappings.push_back(mapping_of(mesh, first));
    }
    const std::vector<bool> mirrored = split_mirrored(mesh, mappings);
    std::vector<dvec3> sums(mesh.vertices.size(), dvec3(0.0));
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        sums[mesh.indices[i]] += mappings[i / 3].along_u;
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        Vertex& vertex = mesh.vertices[v];
        const dvec3 n = vertex.normal;
        const dvec3 flat = sums[v] - n * glm::dot(n, sums[v]);
        const bool usable = glm::length(flat) > 1e-9 * glm::length(sums[v]);
        const glm::vec3 tangent = usable ? unit_or(flat, any_perpendicular(vertex.normal))
                                         : any_perpendicular(vertex.normal);
        vertex.tangent = glm::vec4(tangent, mirrored[v] ? -1.0F : 1.0F);
    }
}

}  // namespace obscura::renderer::import_detail
