// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::renderer {

class RayScene;

/// Surfaces as a G-buffer stores them, lower row first.
struct SeenSurfaces {
    int width = 0;
    int height = 0;
    std::span<const float> depth_m;
    std::span<const float> normal;  ///< three components of a unit vector a pixel
};

/// Ray-traced accessibility within R from the surfaces that a G-buffer holds: no ray is spent on
/// finding them. Lower row first, exactly 1 where nothing is seen; rays is at least 1. On all of
/// the processor's cores; the image does not depend on how many there are.
[[nodiscard]] std::vector<float> trace_from_buffers(const RayScene& scene, const Camera& camera,
                                                    const SeenSurfaces& surfaces, double radius_m,
                                                    int rays);

}  // namespace obscura::renderer
