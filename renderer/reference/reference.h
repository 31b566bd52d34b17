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

/// How much a surface at distance t < R occludes: all of it, 1 - t/R, or 1 - (t/R)^2.
enum class Falloff { kNone, kLinear, kQuadratic };

/// Whose hemisphere is sampled: the triangle's, or that of the interpolated vertex normals.
enum class NormalKind { kGeometric, kShading };

struct ReferenceOptions {
    double radius_m = 1.0;  ///< > 0; infinity: no limit
    int rays = 256;         ///< a pixel, 1 to 65536
    std::uint64_t seed = 1;
    Falloff falloff = Falloff::kNone;
    NormalKind normal = NormalKind::kGeometric;
};

/// Ray-traced accessibility; upper row first.
struct ReferenceImage {
    int width = 0;
    int height = 0;
    std::vector<float> accessibility;   ///< [0, 1]; exactly 1 where the camera sees nothing
    std::vector<float> standard_error;  ///< of each value
    std::vector<float> depth_m;  ///< view depth of the exact intersection; kBackgroundDepth_m
};

/// Called now and then with the share of pixels done, [0, 1], from one thread at a time; returning
/// false stops the work.
using ReferenceProgress = std::function<bool(double)>;

/// A scene's triangles in a bounding volume hierarchy, built once for any number of images. Keeps
/// what it needs of the scene: `scene` may go away afterwards.
class ReferenceScene {
  public:
    explicit ReferenceScene(const Scene& scene);
    ~ReferenceScene();
    ReferenceScene(ReferenceScene&&) noexcept;
    ReferenceScene& operator=(ReferenceScene&&) noexcept;

    /// Accessibility within R at what each pixel's middle shows, on
    /// all cores; the same for a seed whatever the number of threads. Throws bad input for a
    /// radius, number of rays, camera or size that is not allowed, failure when stopped.
    [[nodiscard]] ReferenceImage trace(const Camera& camera, int width, int height,
                                       const ReferenceOptions& options,
                                       const ReferenceProgress& progress = {}) const;

    /// SHA-256 of the geometry and the coverage of its surfaces: the cache's key.
    [[nodiscard]] const std::string& geometry_sha256() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// trace(), kept in `folder` under a hash of geometry, camera, size and options, so that it is paid
/// once. A damaged file is noticed, named in the log and made again.
[[nodiscard]] ReferenceImage cached_reference(const std::filesystem::path& folder,
                                              const ReferenceScene& scene, const Camera& camera,
                                              int width, int height,
                                              const ReferenceOptions& options,
                                              const ReferenceProgress& progress = {});

}  // namespace obscura::renderer
