// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

namespace obscura::renderer {

// Plain shapes in one white, double-sided material, for scenes whose accessibility is known.

/// A scene with that material and nothing in it.
[[nodiscard]] Scene analytic_scene();

/// A parallelogram with corner `origin` and sides u and v; its normal is u x v.
void add_parallelogram(Scene& scene, const glm::dvec3& origin, const glm::dvec3& u,
                       const glm::dvec3& v);

/// The floor y = 0 from x = `left` on, `reach` far to the right and to both sides.
void add_floor(Scene& scene, double left, double reach);

/// A half-plane that rises from the line x = 0 of the floor y = 0 and leaves the floor on its
/// right open by `opening_rad`.
void add_leaning_wall(Scene& scene, double opening_rad, double reach);

/// A ball of latitude and longitude facets, `rings` from pole to pole, twice as many around.
void add_ball(Scene& scene, const glm::dvec3& middle, double radius, int rings);

/// A level disk of `segments` facets.
void add_disk(Scene& scene, const glm::dvec3& middle, double radius, int segments);

/// An upright tube without ends, from y = 0 to `height`, around the Y axis.
void add_tube(Scene& scene, double radius, double height, int segments);

}  // namespace obscura::renderer
