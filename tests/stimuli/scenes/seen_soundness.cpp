// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "tests/stimuli/scenes/seen_soundness.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace obscura::stimuli {
namespace {

using renderer::Mesh;
using renderer::Scene;

constexpr unsigned kSolid = 1;
constexpr unsigned kCutOut = 2;
constexpr float kTouch_m = 0.003F;
constexpr float kFight_m = 0.0001F;

struct Hit {
    float t = 0.0F;
    unsigned mesh = 0;
    unsigned triangle = 0;
    glm::vec3 normal{0.0F};  ///< unit length
};

/// From a point to a triangle.
float distance_to(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
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

/// Which piece each triangle of a mesh belongs to: those that share a corner's place are one.
std::vector<std::uint32_t> pieces_of(const Mesh& mesh, std::uint32_t first) {
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto key = [&](std::uint32_t i) {
        const glm::vec3 p = mesh.vertices[i].position_m;
        return std::tuple(p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> parent(count);
    std::iota(parent.begin(), parent.end(), 0U);
    const std::function<std::uint32_t(std::uint32_t)> root = [&](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (std::uint32_t i = 1; i < count; ++i) {
        if (key(order[i]) == key(order[i - 1])) parent[root(order[i])] = root(order[i - 1]);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        parent[root(mesh.indices[i + 1])] = root(mesh.indices[i]);
        parent[root(mesh.indices[i + 2])] = root(mesh.indices[i]);
    }
    std::map<std::uint32_t, std::uint32_t> number;
    std::vector<std::uint32_t> pieces;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto next = first + static_cast<std::uint32_t>(number.size());
        pieces.push_back(number.try_emplace(root(mesh.indices[i]), next).first->second);
    }
    return pieces;
}

/// Marks those pieces that come near another although no ray says so, as where two lie edge to edge
/// in one plane: looks around the corners of both.
void look_around(const Scene& scene, const Triangles& triangles,
                 const std::vector<std::vector<std::uint32_t>>& piece_of,
                 std::vector<char>& touches) {
    const auto for_corners = [&](const std::function<void(std::uint32_t, const glm::vec3&)>& see) {
        for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
            const Mesh& mesh = scene.meshes[m];
            for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
                see(piece_of[m][i / 3], mesh.vertices[mesh.indices[i]].position_m);
            }
        }
    };
    std::map<std::uint32_t, std::pair<glm::vec3, glm::vec3>> alone;  // with their boxes
    for_corners([&](std::uint32_t own, const glm::vec3& at) {
        if (touches[own] != 0) return;
        auto& [low, high] = alone.try_emplace(own, at, at).first->second;
        low = glm::min(low, at);
        high = glm::max(high, at);
    });
    for_corners([&](std::uint32_t own, const glm::vec3& at) {
        for (const auto& [piece, box] : alone) {
            const bool outside = glm::any(glm::lessThan(at, box.first - kTouch_m)) ||
                                 glm::any(glm::greaterThan(at, box.second + kTouch_m));
            if (outside || touches[piece] != 0) continue;
            const bool met = triangles.any_near(at, kTouch_m, [&](unsigned mesh, unsigned t) {
                return own == piece ? piece_of[mesh][t] != piece : piece_of[mesh][t] == piece;
            });
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

std::vector<std::string> faults_as_seen(const Scene& scene, const MayLeave& may_leave) {
    const Triangles triangles(scene);
    Faults faults;
    for (const renderer::Camera& camera : scene.cameras) {
        look(scene, triangles, camera, may_leave, faults);
    }
    // A ray that grazes a seam of two walls may meet both: single ones are left out.
    return faults.lines(/*least=*/3);
}

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
