// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/buffer_rays.h"

#include <xmmintrin.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>

#include "renderer/passes/shared_constants.h"
#include "renderer/reference/ray_scene.h"
#include "renderer/reference/sampler.h"
#include "renderer/scene/camera.h"

namespace obscura::renderer {
namespace {

constexpr int kSide = BlockSampler::kSide;
/// How far off its surface a ray starts, as a share of the depth: what interpolation in floats over
/// large triangles may leave of it.
constexpr float kOffset = 3.0e-5F;
/// The same as a share of the size of the triangle, which limits where floats can put a point of
/// it.
constexpr float kTriangleOffset = 4.0e-7F;
/// How far before and behind the stored depth a pixel's face is looked for, as a share of it.
constexpr float kProbe = 1.0e-3F;
static_assert(kPacket == kSide * kSide);

/// Duff et al. 2017, equation 6, with zeros of both signs alike, as a shader sees them.
glm::mat3 frame_of(const glm::vec3& n) {
    const float sign = n.z >= 0.0F ? 1.0F : -1.0F;
    const float s = -1.0F / (sign + n.z);
    const float t = n.x * n.y * s;
    return {glm::vec3(1.0F + sign * n.x * n.x * s, sign * t, -sign * n.x),
            glm::vec3(t, sign + n.y * n.y * s, -n.y), n};
}

/// Where rays start, in the world relative to the scene's origin, and about which frame.
struct Start {
    glm::vec3 at_m;
    glm::mat3 frame;
};

class Tracer {
  public:
    Tracer(const RayScene& scene, const Camera& camera, const SeenSurfaces& surfaces,
           double radius_m, int rays)
        : scene_(scene),
          matrices_(matrices_of(camera, surfaces.width, surfaces.height)),
          surfaces_(surfaces),
          radius_m_(static_cast<float>(radius_m)),
          rays_(rays),
          sampler_(rays),
          world_from_view_(glm::transpose(glm::mat3(matrices_.view_from_world))),
          eye_m_(glm::vec3(glm::dvec3(camera.position_m) - scene.origin_m())),
          open_(surfaces.depth_m.size(), 1.0F) {}

    std::vector<float> run() {
        const int columns = (surfaces_.width + kSide - 1) / kSide;
        const int rows = (surfaces_.height + kSide - 1) / kSide;
        std::atomic<int> next{0};
        const auto work = [&] {
            const unsigned saved = _mm_getcsr();
            _mm_setcsr(saved | kFlushDenormals);
            Block block(static_cast<std::size_t>(kSide * kSide * rays_));
            for (int row = next++; row < rows; row = next++) {
                for (int column = 0; column < columns; ++column) trace(block, column, row);
            }
            _mm_setcsr(saved);
        };
        const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
        {
            std::vector<std::jthread> others;
            for (unsigned i = 1; i < cores; ++i) others.emplace_back(work);
            work();
        }
        return std::move(open_);
    }

  private:
    struct Block {
        explicit Block(std::size_t rays) : x(rays), y(rays), z(rays) {}
        std::vector<float> x, y, z;  ///< directions about +Z
        std::array<Start, kSide * kSide> starts{};
        std::array<glm::vec3, kSide * kSide> towards{};
        std::array<std::size_t, kSide * kSide> pixels{};
        std::array<int, kSide * kSide> parts{};
        std::array<int, kSide * kSide> met{};  ///< rays that met something
        int count = 0;
    };

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(surfaces_.width) +
               static_cast<std::size_t>(x);
    }

    /// The ray from the eye through a pixel's middle, as long as a metre of depth.
    [[nodiscard]] glm::vec3 towards(int x, int y) const {
        const glm::vec2 uv((static_cast<float>(x) + 0.5F) / static_cast<float>(surfaces_.width),
                           (static_cast<float>(y) + 0.5F) / static_cast<float>(surfaces_.height));
        const glm::vec2 ray = (uv * 2.0F - 1.0F) * matrices_.ray_scale + matrices_.ray_offset;
        return world_from_view_ * glm::vec3(ray, -1.0F);
    }

    void add_pixel(Block& block, int x, int y) {
        const std::size_t pixel = index(x, y);
        if (!(surfaces_.depth_m[pixel] < kBackgroundLimit_m)) return;
        const auto slot = static_cast<std::size_t>(block.count++);
        block.towards[slot] = towards(x, y);
        block.pixels[slot] = pixel;
        block.parts[slot] = BlockSampler::part_of(x, y);
        block.met[slot] = 0;
    }

    /// The face that each pixel shows, which a G-buffer does not hold and the truth's hemisphere
    /// stands on: one packet of rays over the last thousandth before the stored depth and after it.
    /// Where it finds none (a silhouette), the stored depth and normal stand.
    void find_faces(Block& block) const {
        alignas(64) int valid[kPacket];
        RTCRayHit16 packet{};
        for (int i = 0; i < kPacket; ++i) {
            const auto slot = static_cast<std::size_t>(std::min(i, block.count - 1));
            valid[i] = i < block.count ? -1 : 0;
            const float depth_m = surfaces_.depth_m[block.pixels[slot]];
            packet.ray.org_x[i] = eye_m_.x;
            packet.ray.org_y[i] = eye_m_.y;
            packet.ray.org_z[i] = eye_m_.z;
            packet.ray.dir_x[i] = block.towards[slot].x;
            packet.ray.dir_y[i] = block.towards[slot].y;
            packet.ray.dir_z[i] = block.towards[slot].z;
            packet.ray.tnear[i] = depth_m * (1.0F - kProbe);
            packet.ray.tfar[i] = depth_m * (1.0F + kProbe);
            packet.ray.mask[i] = ~0U;
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        RayScene::Context context(true);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcIntersect16(valid, scene_.embree(), &context, &packet);
        for (int i = 0; i < block.count; ++i) {
            const auto slot = static_cast<std::size_t>(i);
            const glm::vec3& ray = block.towards[slot];
            const float* const stored = &surfaces_.normal[3 * block.pixels[slot]];
            float depth_m = surfaces_.depth_m[block.pixels[slot]];
            glm::vec3 n = world_from_view_ * glm::vec3(stored[0], stored[1], stored[2]);
            const glm::vec3 face(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]);
            const float squared = glm::dot(face, face);
            float offset_m = kOffset * (depth_m + glm::length(eye_m_));
            if (packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID && squared > 0.0F) {
                depth_m = packet.ray.tfar[i];
                n = face * ((glm::dot(face, ray) > 0.0F ? -1.0F : 1.0F) / std::sqrt(squared));
                // Twice the triangle's area is as long as its normal.
                offset_m = std::max(offset_m, kTriangleOffset * std::sqrt(std::sqrt(squared)));
            }
            block.starts[slot] = {eye_m_ + depth_m * ray + offset_m * n, frame_of(n)};
        }
    }

    void trace(Block& block, int column, int row) {
        block.count = 0;
        for (int y = row * kSide; y < std::min((row + 1) * kSide, surfaces_.height); ++y) {
            for (int x = column * kSide; x < std::min((column + 1) * kSide, surfaces_.width); ++x) {
                add_pixel(block, x, y);
            }
        }
        if (block.count == 0) return;
        find_faces(block);
        sampler_.directions(
            static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint64_t>(column),
            block.x.data(), block.y.data(), block.z.data());
        const int all = block.count * rays_;
        for (int first = 0; first < all; first += kPacket) cast(block, first, all);
        for (int i = 0; i < block.count; ++i) {
            const auto slot = static_cast<std::size_t>(i);
            open_[block.pixels[slot]] =
                1.0F - static_cast<float>(block.met[slot]) / static_cast<float>(rays_);
        }
    }

    /// Sixteen rays: those of one pixel after the other.
    void cast(Block& block, int first, int all) const {
        alignas(64) int valid[kPacket];
        RTCRay16 packet{};
        for (int i = 0; i < kPacket; ++i) {
            const int ray = std::min(first + i, all - 1);
            valid[i] = first + i < all ? -1 : 0;
            const auto slot = static_cast<std::size_t>(ray / rays_);
            const auto k = static_cast<std::size_t>(block.parts[slot] * rays_ + ray % rays_);
            const Start& start = block.starts[slot];
            const glm::vec3 towards = start.frame * glm::vec3(block.x[k], block.y[k], block.z[k]);
            packet.org_x[i] = start.at_m.x;
            packet.org_y[i] = start.at_m.y;
            packet.org_z[i] = start.at_m.z;
            packet.dir_x[i] = towards.x;
            packet.dir_y[i] = towards.y;
            packet.dir_z[i] = towards.z;
            packet.tnear[i] = 0.0F;
            packet.tfar[i] = radius_m_;
            packet.mask[i] = ~0U;
        }
        RayScene::Context context(false);
        rtcOccluded16(valid, scene_.embree(), &context, &packet);
        for (int i = 0; i < kPacket && first + i < all; ++i) {
            if (packet.tfar[i] < 0.0F) ++block.met[static_cast<std::size_t>((first + i) / rays_)];
        }
    }

    const RayScene& scene_;
    CameraMatrices matrices_;
    SeenSurfaces surfaces_;
    float radius_m_;
    int rays_;
    BlockSampler sampler_;
    glm::mat3 world_from_view_;
    glm::vec3 eye_m_;
    std::vector<float> open_;
};

}  // namespace

std::vector<float> trace_from_buffers(const RayScene& scene, const Camera& camera,
                                      const SeenSurfaces& surfaces, double radius_m, int rays) {
    return Tracer(scene, camera, surfaces, radius_m, rays).run();
}

}  // namespace obscura::renderer
