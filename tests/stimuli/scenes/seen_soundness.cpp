// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "tests/stimuli/scenes/seen_soundness.h"

#include <fmt/format.h>

#include <cmath>

#include "tests/stimuli/scenes/scene_triangles.h"

namespace obscura::stimuli {
namespace {

constexpr float kFight_m = 0.0001F;

bool share_a_corner(const Scene& scene, const Hit& a, const Hit& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Mesh& of_a = scene.meshes[a.mesh];
        const glm::vec3 p = of_a.vertices[of_a.indices[3 * a.triangle + i]].position_m;
        for (std::size_t k = 0; k < 3; ++k) {
            const Mesh& of_b = scene.meshes[b.mesh];
            if (of_b.vertices[of_b.indices[3 * b.triangle + k]].position_m == p) return true;
        }
    }
    return false;
}

/// The mesh whose face fights with the one that a ray met first; empty where none does.
std::string fighting(const Scene& scene, const Triangles& triangles, const glm::vec3& from,
                     const glm::vec3& way, const Hit& first) {
    const float slope = std::abs(glm::dot(first.normal, way));
    if (slope < 0.2F) return "";
    std::string other;
    const float reach = kFight_m / slope;
    triangles.each(from, way, first.t - 1e-4F, first.t + reach, kSolid, [&](const Hit& hit) {
        if (hit.mesh == first.mesh && hit.triangle == first.triangle) return false;
        if (glm::dot(hit.normal, first.normal) < 0.9995F) return false;
        if (share_a_corner(scene, hit, first)) return false;
        other = scene.meshes[hit.mesh].name;
        return true;
    });
    return other;
}

void look(const Scene& scene, const Triangles& triangles, const renderer::Camera& camera,
          const MayLeave& may_leave, Faults& faults) {
    constexpr int kWide = 480;
    constexpr int kHigh = 270;
    const glm::vec3 ahead = glm::normalize(camera.target_m - camera.position_m);
    const glm::vec3 right = glm::normalize(glm::cross(ahead, glm::vec3(0.0F, 1.0F, 0.0F)));
    const glm::vec3 up = glm::cross(right, ahead);
    const float high = std::tan(0.5F * camera.vertical_fov_rad);
    for (int y = 0; y < kHigh; ++y) {
        for (int x = 0; x < kWide; ++x) {
            const float u =
                (2.0F * (static_cast<float>(x) + 0.5F) / kWide - 1.0F) * high * 16.0F / 9;
            const float v = (1.0F - 2.0F * (static_cast<float>(y) + 0.5F) / kHigh) * high;
            const glm::vec3 way = glm::normalize(ahead + u * right + v * up);
            Hit hit;
            if (!triangles.first(camera.position_m, way, hit)) {
                if (!may_leave(camera, way)) {
                    faults.add(camera.name + " sees out of the scene", way);
                }
                continue;
            }
            const glm::vec3 at = camera.position_m + hit.t * way;
            const Mesh& mesh = scene.meshes[hit.mesh];
            if (glm::dot(hit.normal, way) > 0.0F && !scene.materials[mesh.material].double_sided) {
                faults.add(fmt::format("{} sees the back of {}", camera.name, mesh.name), at);
                continue;
            }
            const std::string other = fighting(scene, triangles, camera.position_m, way, hit);
            if (!other.empty()) {
                faults.add(
                    fmt::format("{} sees {} and {} in one place", camera.name, mesh.name, other),
                    at);
            }
        }
    }
}

}  // namespace

std::vector<std::string> faults_as_seen(const Scene& scene, const MayLeave& may_leave) {
    const Triangles triangles(scene);
    Faults faults;
    for (const renderer::Camera& camera : scene.cameras) {
        look(scene, triangles, camera, may_leave, faults);
    }
    // A ray that grazes a seam of two walls may meet both: single ones are left out.
    return faults.lines(/*least=*/3);
}

}  // namespace obscura::stimuli
