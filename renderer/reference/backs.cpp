// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/backs.h"

#include <algorithm>

#include "renderer/reference/pixel_tracer.h"
#include "renderer/reference/ray_scene.h"

namespace obscura::renderer {
namespace {

constexpr int kWidth_px = 96;
constexpr int kHeight_px = 54;

double share_of_backs(const RayScene& scene, const Camera& camera, Backs backs) {
    const PixelRays pixels(camera, kWidth_px, kHeight_px, scene.origin_m());
    RayScene::Context context(false);  // nothing is culled
    int met = 0;
    int from_behind = 0;
    for (int i = 0; i < kWidth_px * kHeight_px; ++i) {
        const glm::vec3 start(pixels.position_m());
        const glm::vec3 towards(pixels.direction(i % kWidth_px, i / kWidth_px));
        RTCRayHit ray{ray_from(start, towards, static_cast<float>(pixels.near_m()),
                               static_cast<float>(pixels.far_m())),
                      {}};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene.embree(), &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
        ++met;
        const bool counts = backs == Backs::kAll || scene.geometry(ray.hit.geomID).single_sided;
        const glm::vec3 normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
        if (counts && glm::dot(normal, towards) > 0.0F) ++from_behind;
    }
    return met > 0 ? static_cast<double>(from_behind) / met : 0.0;
}

}  // namespace

std::vector<double> shares_of_backs(const Scene& scene, const std::vector<Camera>& cameras,
                                    Backs backs) {
    const bool all_blended =
        std::all_of(scene.meshes.begin(), scene.meshes.end(), [&scene](const Mesh& mesh) {
            return scene.materials[mesh.material].coverage == Coverage::kBlended;
        });
    if (all_blended) return std::vector<double>(cameras.size(), 0.0);
    const RayScene rays(scene);
    std::vector<double> shares;
    for (const Camera& camera : cameras) shares.push_back(share_of_backs(rays, camera, backs));
    return shares;
}

}  // namespace obscura::renderer
