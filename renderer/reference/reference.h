// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::renderer {

class RayScene;

/// The most rays a pixel.
inline constexpr int kMostReferenceRays = 65536;

/// How much a surface at distance t < R occludes: wholly, by 1 - t/R, or by 1 - (t/R)^2.
enum class Falloff { kNone, kLinear, kQuadratic };

/// Whose hemisphere is sampled: the triangle's, or that of the interpolated vertex normals. Either
/// is turned to the side of the triangle that the camera sees: on backs as by the rasteriser, and
/// also where vertex normals point to the wrong side of their own triangle, which the rasteriser
/// leaves as they are. Directions of the shading hemisphere that lie below the triangle's own plane
/// lead into the surface and count as occluded at distance 0.
enum class NormalKind { kGeometric, kShading };

struct ReferenceOptions {
    double radius_m = 1.0;  ///< > 0; infinity: no limit, with Falloff::kNone only
    int rays = 256;         ///< a pixel, 1 to kMostReferenceRays
    std::uint64_t seed = 1;
    Falloff falloff = Falloff::kNone;
    NormalKind normal = NormalKind::kGeometric;
    int threads = 0;  ///< 0: one a core. The image does not depend on it.
};

/// Ray-traced accessibility; upper row first.
struct ReferenceImage {
    int width = 0;
    int height = 0;
    std::vector<float> accessibility;  ///< [0, 1]; exactly 1 where the camera sees nothing
    /// Of each value, from the spread between consecutive parts of the pixel's scrambled sequence
    /// (8 from 32 rays on): rather too high than too low, see sampler.h. 0 where the camera sees
    /// nothing; 0.5, the most there can be, for 1 ray.
    std::vector<float> standard_error;
    std::vector<float> depth_m;  ///< view depth of the exact intersection; kBackgroundDepth_m
};

/// Called now and then with the share of pixels done, [0, 1], from one thread at a time; returning
/// false stops the work.
using ReferenceProgress = std::function<bool(double)>;

/// A scene's triangles in a bounding volume hierarchy, built once for any number of images. Keeps
/// what it needs of the scene: `scene` may go away afterwards. Every triangle occludes from both
/// sides; the camera sees what the rasteriser draws. Cut-out surfaces have their holes, blended
/// ones are left out.
class ReferenceScene {
  public:
    /// Triangles without area or with coordinates that are not finite are left out and counted in
    /// the log. Throws bad input for an index, material or texture that is out of range, and for a
    /// scene in which no triangle is left.
    explicit ReferenceScene(const Scene& scene);
    ~ReferenceScene();
    ReferenceScene(ReferenceScene&&) noexcept;
    ReferenceScene& operator=(ReferenceScene&&) noexcept;

    /// Accessibility within R at what each pixel's middle shows; the same for a seed whatever the
    /// number of threads. Width and height are 1 to 16384. Throws bad input for a radius, number of
    /// rays, camera or size that is not allowed, failure when stopped.
    [[nodiscard]] ReferenceImage trace(const Camera& camera, int width, int height,
                                       const ReferenceOptions& options,
                                       const ReferenceProgress& progress = {}) const;

    /// SHA-256 of the geometry and the coverage of its surfaces: the cache's key.
    [[nodiscard]] const std::string& geometry_sha256() const;

    /// Triangles that were left out because they have no area or are not finite.
    [[nodiscard]] std::size_t skipped_triangles() const;

    /// What is behind it, for the benchmark.
    [[nodiscard]] const RayScene& rays() const { return *rays_; }

  private:
    std::unique_ptr<RayScene> rays_;
};

/// Throws bad input naming the option, its value and what is allowed.
void check_options(const ReferenceOptions& options);

/// trace(), kept in `folder` under a hash of geometry, camera, size and options, so that it is paid
/// once. A damaged file is noticed, named in the log and made again.
[[nodiscard]] ReferenceImage cached_reference(const std::filesystem::path& folder,
                                              const ReferenceScene& scene, const Camera& camera,
                                              int width, int height,
                                              const ReferenceOptions& options,
                                              const ReferenceProgress& progress = {});

}  // namespace obscura::renderer
