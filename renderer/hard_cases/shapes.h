// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "renderer/scene/scene.h"

namespace obscura::renderer::shapes {

/// A scene with one white material, seen from both sides, and no triangles.
[[nodiscard]] Scene empty();

/// Adds a parallelogram with corner `origin` and sides u and v; its normal is u x v.
void add_quad(Scene& scene, const glm::vec3& origin, const glm::vec3& u, const glm::vec3& v);

/// Adds six outward faces.
void add_box(Scene& scene, const glm::vec3& low, const glm::vec3& high);

/// Adds a ball of triangles, `rings` from pole to pole and twice as many around.
void add_sphere(Scene& scene, const glm::vec3& centre, float radius, int rings = 64);

/// A plane through (0, 0, -distance), turned about the x axis by `tilt_rad` from facing the camera,
/// that fills the view of camera() and ends nowhere in sight.
[[nodiscard]] Scene plane(float distance, float tilt_rad);

/// At the origin, along -Z, 60 degrees; near and far fit a scene of about `distance`.
[[nodiscard]] Camera camera(float distance);

/// Every length of the scene and its cameras times `factor`, then moved by `shift`.
[[nodiscard]] Scene transformed(Scene scene, float factor, const glm::vec3& shift);
[[nodiscard]] Camera transformed(Camera camera, float factor, const glm::vec3& shift);

/// Boxes of eighths of a metre on a floor before a wall, 4 to 8 m away: some of everything.
[[nodiscard]] Scene clutter();

}  // namespace obscura::renderer::shapes
