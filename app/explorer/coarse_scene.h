// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "renderer/scene/scene.h"

namespace obscura::app::explorer {

/// As many triangles as a software renderer draws fifteen times a second.
inline constexpr std::size_t kMostMovingTriangles = 20'000;

struct CoarseScene {
    renderer::Scene scene;  ///< its textures have sizes but no texels
    float error_m = 0.0F;   ///< about how far its surfaces are off
};

/// The scene with at most about that many triangles, as near to its surfaces as that allows
/// (Garland and Heckbert 1997, by meshoptimizer): for images that are seen for a moment. Surfaces
/// keep their materials; what has holes is thinned out last. Nothing where the scene has no more
/// triangles than that, or `go_on` said false.
[[nodiscard]] std::optional<CoarseScene> coarser(
    const renderer::Scene& scene, std::size_t most_triangles = kMostMovingTriangles,
    const std::function<bool()>& go_on = [] { return true; });

}  // namespace obscura::app::explorer
