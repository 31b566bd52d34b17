// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/clusters.h"

#include <algorithm>
#include <cmath>

namespace obscura::renderer {
namespace {

/// Of the size of what is added up; the vertex shader's own rounding is a thousand times smaller.
constexpr double kMargin = 1e-4;

[[nodiscard]] bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::vector<Cluster> clusters_of(const Mesh& mesh) {
    std::vector<Cluster> clusters;
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3 * kClusterTriangles) {
        Cluster cluster;
        cluster.first_index = first;
        cluster.index_count = std::min(3 * kClusterTriangles, mesh.indices.size() - first);
        const glm::vec3& begin = mesh.vertices[mesh.indices[first]].position_m;
        cluster.box = {begin, begin};
        for (std::size_t i = first; i < first + cluster.index_count; ++i) {
            const glm::vec3& at = mesh.vertices[mesh.indices[i]].position_m;
            cluster.bounded = cluster.bounded && finite(at);
            cluster.box.low_m = glm::min(cluster.box.low_m, at);
            cluster.box.high_m = glm::max(cluster.box.high_m, at);
        }
        clusters.push_back(cluster);
    }
    return clusters;
}

Frustum::Frustum(const CameraMatrices& camera) : eye_m_(camera.eye_m) {
    const glm::dmat4 rows = glm::transpose(glm::dmat4(camera.clip_from_view));
    const glm::dmat3 world_from_view = glm::transpose(glm::dmat3(camera.view_from_world));
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        // -w <= x <= w, and so for y and z.
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        const glm::dvec4 side = rows[3] + sign * rows[static_cast<int>(i / 2)];
        sides_[i] = {world_from_view * glm::dvec3(side), side.w};
    }
}

bool Frustum::may_show(const Cluster& cluster) const {
    if (!cluster.bounded) return true;
    const glm::dvec3 low_m = glm::dvec3(cluster.box.low_m) - eye_m_;
    const glm::dvec3 high_m = glm::dvec3(cluster.box.high_m) - eye_m_;
    return std::all_of(sides_.begin(), sides_.end(), [&](const HalfSpace& side) {
        const glm::dvec3 at_low = side.normal * low_m;
        const glm::dvec3 at_high = side.normal * high_m;
        const glm::dvec3 most = glm::max(at_low, at_high);
        const glm::dvec3 size = glm::max(glm::abs(at_low), glm::abs(at_high));
        const double margin = kMargin * (size.x + size.y + size.z + std::abs(side.offset));
        return !(most.x + most.y + most.z + side.offset < -margin);
    });
}

}  // namespace obscura::renderer
