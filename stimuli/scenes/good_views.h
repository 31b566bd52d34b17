// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::stimuli {

/// A view of a scene that was found, and what was seen of it.
struct FoundView {
    renderer::Camera camera;
    double seen = 0.0;      ///< share of the image that shows surfaces
    double occluded = 0.0;  ///< mean of 1 - accessibility over them, within radius_m
    double spread = 0.0;    ///< standard deviation of the accessibility: how much there is to see
};

/// A radius of ambient occlusion, in metres, that suits what a camera looks at: a twenty-fifth of
/// the distance to its target.
[[nodiscard]] double fitting_radius_m(const renderer::Camera& camera);

/// Up to `count` views of a scene, the best first: cameras all around it and, at a person's eye
/// height, inside it, of which those are taken that see much geometry at several distances with
/// occlusion that varies, and that differ from each other. By a few rays each; the same every time.
/// Throws bad input for a scene in which nothing can be seen.
[[nodiscard]] std::vector<FoundView> find_views(const renderer::Scene& scene, int count);

/// The camera as a study file has it: `camera = { position_m = ... }`.
[[nodiscard]] std::string study_line(const renderer::Camera& camera);

}  // namespace obscura::stimuli
