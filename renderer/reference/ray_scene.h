// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// Rays that are traced together.
inline constexpr int kPacket = 16;
/// Flush to zero and denormals are zero (Intel SDM, volume 1, 10.2.3).
inline constexpr unsigned kFlushDenormals = 0x8040;

/// A ray that any geometry may stop between two distances along `towards`, in its lengths.
[[nodiscard]] inline RTCRay ray_from(const glm::vec3& start, const glm::vec3& towards, float near,
                                     float far) {
    RTCRay ray{};
    ray.org_x = start.x;
    ray.org_y = start.y;
    ray.org_z = start.z;
    ray.dir_x = towards.x;
    ray.dir_y = towards.y;
    ray.dir_z = towards.z;
    ray.tnear = near;
    ray.tfar = far;
    ray.mask = ~0U;
    return ray;
}

/// Embree's view of a scene, and what the filter functions need to judge a hit. Coordinates inside
/// are shifted by origin_m(), so that a scene far from the world's origin keeps its precision; the
/// shift is chosen so that it rounds nothing.
class RayScene {
  public:
    /// Which of its instructions Embree may use: all that the machine has, or none that fuse a
    /// multiplication with an addition, so that every machine meets the same triangles.
    enum class Kernels { kFastest, kWithoutFusedMultiplication };

    explicit RayScene(const Scene& scene, Kernels kernels = Kernels::kFastest);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// Whose rays are traced: the camera's are subject to back-face culling, as the rasteriser's.
    struct Context : RTCIntersectContext {
        explicit Context(bool from_camera) : camera(from_camera) { rtcInitIntersectContext(this); }
        bool camera;
    };

    /// A triangle, relative to origin_m().
    struct Triangle {
        std::array<glm::dvec3, 3> corner;
        std::array<glm::vec3, 3> normal;  ///< of the vertices
    };

    [[nodiscard]] RTCScene embree() const { return scene_; }
    [[nodiscard]] const glm::dvec3& origin_m() const { return origin_m_; }
    /// Of everything that rays can meet; computed when it is first asked for.
    [[nodiscard]] const std::string& sha256() const;
    [[nodiscard]] std::size_t skipped() const { return skipped_; }
    /// No two have the same.
    [[nodiscard]] std::size_t number() const { return number_; }
    [[nodiscard]] Triangle triangle(unsigned geometry, unsigned primitive) const;

    /// One mesh: its triangles that can be hit, and the alpha of its surface.
    struct Geometry {
        std::vector<glm::vec3> positions;  ///< relative to origin_m(); one more than there are
                                           ///< vertices: Embree reads 16 bytes of each
        std::vector<glm::vec3> normals;
        std::vector<glm::vec2> uvs;          ///< of a cut-out only
        std::vector<std::uint32_t> indices;  ///< three a triangle
        std::size_t mesh = 0;                ///< index into Scene::meshes
        bool single_sided = true;
        bool cut_out = false;
        float opacity = 1.0F;
        float alpha_cutoff = 0.5F;
        int alpha_width = 0;  ///< 0: no texture
        int alpha_height = 0;
        std::vector<std::uint8_t> alpha;

        /// Whether a cut-out has a surface there; u and v are Embree's.
        [[nodiscard]] bool covers(unsigned primitive, float u, float v) const;
    };

    /// By Embree's geomID.
    [[nodiscard]] const Geometry& geometry(unsigned number) const { return *geometries_[number]; }
    [[nodiscard]] unsigned geometries() const { return static_cast<unsigned>(geometries_.size()); }

  private:
    void add(const Scene& scene, std::size_t number);
    void attach(std::unique_ptr<Geometry> geometry);

    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    glm::dvec3 origin_m_{0.0};
    std::vector<std::unique_ptr<Geometry>> geometries_;  ///< by Embree's geomID
    std::size_t number_;
    std::size_t skipped_ = 0;  ///< triangles: those without area, and
    std::size_t broken_ = 0;   ///< those with coordinates that are not finite
    mutable std::once_flag hashed_;
    mutable std::string sha256_;
};

}  // namespace obscura::renderer
