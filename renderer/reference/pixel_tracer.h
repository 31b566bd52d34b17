// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/reference/ray_scene.h"
#include "renderer/reference/reference.h"
#include "renderer/reference/sampler.h"

namespace obscura::renderer {

/// The rays through the middles of the pixels, in double precision, as the rasteriser's camera has
/// them. Throws bad input for a camera that is not allowed.
class PixelRays {
  public:
    PixelRays(const Camera& camera, int width, int height, const glm::dvec3& scene_origin_m);

    [[nodiscard]] const glm::dvec3& position_m() const { return position_m_; }
    /// Not of unit length: one step along it is one metre of view depth.
    [[nodiscard]] glm::dvec3 direction(int x, int y) const;
    [[nodiscard]] double near_m() const { return near_m_; }
    [[nodiscard]] double far_m() const { return far_m_; }
    /// Says which pixel it is, whatever the image's size.
    [[nodiscard]] std::uint64_t number(int x, int y) const {
        return (static_cast<std::uint64_t>(y) << 32) | static_cast<std::uint64_t>(x);
    }

  private:
    glm::dvec3 position_m_;
    glm::dvec3 forward_;
    glm::dvec3 right_;  ///< per unit of normalised device coordinate, one metre ahead
    glm::dvec3 up_;
    glm::dvec2 pixels_;
    glm::dvec2 offset_;
    double near_m_;
    double far_m_;
};

struct TracedPixel {
    float accessibility = 1.0F;
    float standard_error = 0.0F;
    float depth_m;  ///< kBackgroundDepth_m where the camera sees nothing
};

/// One thread's work on pixels. While it lives the thread flushes denormal numbers to zero, as
/// Embree's manual advises.
class PixelTracer {
  public:
    PixelTracer(const RayScene& scene, const PixelRays& pixels, const ReferenceOptions& options,
                const HemisphereSampler& sampler);
    ~PixelTracer();
    PixelTracer(const PixelTracer&) = delete;
    PixelTracer& operator=(const PixelTracer&) = delete;

    [[nodiscard]] TracedPixel trace(int x, int y);

    /// The occlusion rays of the pixel that was traced last, which must have shown a surface: for
    /// the benchmark.
    void append_last_rays(std::vector<RTCRay>& rays) const;

  private:
    /// What a pixel's middle shows.
    struct Surface {
        glm::vec3 start_m;           ///< of the rays: off the surface by more than rounding
        glm::dvec3 normal;           ///< whose hemisphere is sampled, unit length
        glm::vec3 geometric_normal;  ///< towards the camera, unit length
        double depth_m;
    };
    [[nodiscard]] bool find_surface(int x, int y, Surface& surface) const;
    void cast_occlusion(const Surface& surface);
    void cast_falloff(const Surface& surface);
    [[nodiscard]] TracedPixel gathered(const Surface& surface) const;

    const RayScene& scene_;
    const PixelRays& pixels_;
    const ReferenceOptions& options_;
    const HemisphereSampler& sampler_;
    glm::vec3 start_m_{0.0F};       ///< of the rays of the last pixel
    std::vector<float> x_, y_, z_;  ///< directions, world space
    std::vector<float> occlusion_;  ///< of each ray, [0, 1]
    unsigned saved_float_mode_;
};

}  // namespace obscura::renderer
