// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::stimuli {

using renderer::Mesh;
using renderer::Scene;

inline constexpr unsigned kSolid = 1;
inline constexpr unsigned kCutOut = 2;

struct Hit {
    float t = 0.0F;
    unsigned mesh = 0;
    unsigned triangle = 0;
    glm::vec3 normal{0.0F};  ///< unit length
};

/// From a point to a triangle.
inline float distance_to(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b,
                         const glm::vec3& c) {
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const auto inside = [&](const glm::vec3& from, const glm::vec3& to) {
        return glm::dot(glm::cross(to - from, p - from), normal) >= 0.0F;
    };
    const float area = glm::length(normal);
    if (area > 0.0F && inside(a, b) && inside(b, c) && inside(c, a)) {
        return std::abs(glm::dot(p - a, normal)) / area;
    }
    const auto to_edge = [&](const glm::vec3& from, const glm::vec3& to) {
        const glm::vec3 way = to - from;
        const float length2 = std::max(glm::dot(way, way), 1e-20F);
        const float t = std::clamp(glm::dot(p - from, way) / length2, 0.0F, 1.0F);
        return glm::distance(p, from + t * way);
    };
    return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

/// The scene's triangles, all of them but of blended surfaces, for single rays from any side.
class Triangles {
  public:
    explicit Triangles(const Scene& scene) : scene_(scene), device_(rtcNewDevice(nullptr)) {
        embree_ = rtcNewScene(device_);
        rtcSetSceneFlags(embree_,
                         static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION |
                                                    RTC_SCENE_FLAG_ROBUST));
        for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
            const Mesh& mesh = scene.meshes[i];
            const renderer::Coverage coverage = scene.materials[mesh.material].coverage;
            if (coverage == renderer::Coverage::kBlended || mesh.indices.empty()) continue;
            RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                       mesh.vertices.data(), offsetof(renderer::Vertex, position_m),
                                       sizeof(renderer::Vertex), mesh.vertices.size());
            rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                       mesh.indices.data(), 0, 3 * sizeof(std::uint32_t),
                                       mesh.indices.size() / 3);
            rtcSetGeometryMask(geometry,
                               coverage == renderer::Coverage::kCutOut ? kCutOut : kSolid);
            rtcCommitGeometry(geometry);
            rtcAttachGeometryByID(embree_, geometry, static_cast<unsigned>(i));
            rtcReleaseGeometry(geometry);
        }
        rtcCommitScene(embree_);
    }
    ~Triangles() {
        rtcReleaseScene(embree_);
        rtcReleaseDevice(device_);
    }
    Triangles(const Triangles&) = delete;
    Triangles& operator=(const Triangles&) = delete;

    /// The first hit; false where there is none.
    [[nodiscard]] bool first(const glm::vec3& from, const glm::vec3& way, Hit& hit) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit ray = ray_of(from, way, 0.0F, 1e9F, kSolid);
        rtcIntersect1(embree_, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
        hit = {ray.ray.tfar, ray.hit.geomID, ray.hit.primID,
               glm::normalize(glm::vec3(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z))};
        return true;
    }
    /// Calls `see` for every hit between the two lengths, in any order, until it returns true.
    void each(const glm::vec3& from, const glm::vec3& way, float near, float far, unsigned mask,
              const std::function<bool(const Hit&)>& see) const {
        struct Collecting : RTCIntersectContext {
            const std::function<bool(const Hit&)>* see;
        } context;
        rtcInitIntersectContext(&context);
        context.see = &see;
        context.filter = [](const RTCFilterFunctionNArguments* call) {
            const auto* own = static_cast<const Collecting*>(call->context);
            const auto* ray = reinterpret_cast<const RTCRay*>(call->ray);
            const auto* hit = reinterpret_cast<const RTCHit*>(call->hit);
            const Hit met{ray->tfar, hit->geomID, hit->primID,
                          glm::normalize(glm::vec3(hit->Ng_x, hit->Ng_y, hit->Ng_z))};
            if (!(*own->see)(met)) call->valid[0] = 0;
        };
        RTCRayHit ray = ray_of(from, way, near, far, mask);
        rtcIntersect1(embree_, &context, &ray);
    }

    /// Whether a triangle for which `of_interest(mesh, triangle)` comes within `radius_m`.
    [[nodiscard]] bool any_near(const glm::vec3& at, float radius_m,
                                const std::function<bool(unsigned, unsigned)>& of_interest) const {
        struct Asked {
            const Scene* scene;
            const std::function<bool(unsigned, unsigned)>* of_interest;
            glm::vec3 at;
            float radius_m;
            bool found;
        } asked{&scene_, &of_interest, at, radius_m, false};
        RTCPointQuery query{};
        query.x = at.x;
        query.y = at.y;
        query.z = at.z;
        query.radius = radius_m;
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(
            embree_, &query, &context,
            [](RTCPointQueryFunctionArguments* call) {
                auto* asking = static_cast<Asked*>(call->userPtr);
                const Mesh& mesh = asking->scene->meshes[call->geomID];
                const auto corner = [&](std::size_t i) {
                    return mesh.vertices[mesh.indices[3 * call->primID + i]].position_m;
                };
                if ((*asking->of_interest)(call->geomID, call->primID) &&
                    distance_to(asking->at, corner(0), corner(1), corner(2)) < asking->radius_m) {
                    asking->found = true;
                }
                return false;
            },
            &asked);
        return asked.found;
    }

  private:
    static RTCRayHit ray_of(const glm::vec3& from, const glm::vec3& way, float near, float far,
                            unsigned mask) {
        RTCRayHit ray{};
        ray.ray.org_x = from.x;
        ray.ray.org_y = from.y;
        ray.ray.org_z = from.z;
        ray.ray.dir_x = way.x;
        ray.ray.dir_y = way.y;
        ray.ray.dir_z = way.z;
        ray.ray.tnear = near;
        ray.ray.tfar = far;
        ray.ray.mask = mask;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        return ray;
    }

    const Scene& scene_;
    RTCDevice device_;
    RTCScene embree_;
};

/// Faults of one kind: how many, and where the first was.
class Faults {
  public:
    void add(const std::string& what, const glm::vec3& at) {
        const auto [entry, fresh] = found_.try_emplace(what, 0, at);
        ++std::get<0>(entry->second);
    }
    [[nodiscard]] std::vector<std::string> lines(int least) const {
        std::vector<std::string> lines;
        for (const auto& [what, found] : found_) {
            const auto& [count, at] = found;
            if (count < least) continue;
            lines.push_back(fmt::format("{}: {} times, first at {:.3f} {:.3f} {:.3f}", what, count,
                                        at.x, at.y, at.z));
        }
        return lines;
    }

  private:
    std::map<std::string, std::tuple<int, glm::vec3>> found_;
};

}  // namespace obscura::stimuli
