// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <vector>

#include "renderer/base/random.h"
#include "renderer/scene/scene.h"

namespace obscura::stimuli {

// Parts that several scenes are put together from, and short names for placing them. Metres;
// meshes as in mesh_builder.h, their uv in metres.

[[nodiscard]] inline glm::mat4 moved(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0F), glm::vec3(x, y, z));
}
[[nodiscard]] inline glm::mat4 moved(const glm::vec3& by_m) {
    return glm::translate(glm::mat4(1.0F), by_m);
}
[[nodiscard]] glm::mat4 about_x(float turn_rad);
[[nodiscard]] glm::mat4 about_y(float turn_rad);
[[nodiscard]] glm::mat4 about_z(float turn_rad);
/// A turn that brings what stands along +Y to lie along +X, or along +Z.
[[nodiscard]] glm::mat4 lie_along_x();
[[nodiscard]] glm::mat4 lie_along_z();

/// Uniform in [low, high).
[[nodiscard]] float draw(base::Random& random, float low, float high);
/// A shade around 1 by a hash: at most `amount` darker, a little warmer or cooler.
[[nodiscard]] glm::vec3 shade_of(std::uint32_t seed, float amount);

/// fbm of 8 x 8 cells and five octaves as a table that all textures share: read at whole multiples
/// of uv (so that it wraps) and free offsets. About [-1, 1].
[[nodiscard]] float shared_noise(glm::vec2 uv);

/// A straight round bar between two points.
[[nodiscard]] renderer::Mesh rod(const glm::vec3& from_m, const glm::vec3& to_m, float radius_m,
                                 int segments = 10);
/// The polyline with its corners rounded to arcs of `bend_m` at most, `steps` pieces each.
[[nodiscard]] std::vector<glm::vec3> rounded_path(std::span<const glm::vec3> corners_m,
                                                  float bend_m, int steps = 6);
/// A round bar or pipe along the polyline with rounded corners.
[[nodiscard]] renderer::Mesh pipe(std::span<const glm::vec3> corners_m, float bend_m,
                                  float radius_m, int segments = 14);
/// A cable that hangs between two points, `sag_m` below the straight line in the middle.
[[nodiscard]] renderer::Mesh cable(const glm::vec3& from_m, const glm::vec3& to_m, float sag_m,
                                   float radius_m, int pieces = 14);
/// A slack cable through points: a spline, without the corners of a pipe.
[[nodiscard]] renderer::Mesh slack_cable(std::span<const glm::vec3> through_m, float radius_m,
                                         int segments = 8);
/// A hexagonal bolt's head on a washer with the thread's end standing out along +Y; the seat is the
/// plane y = 0. `size_m` is the thread's diameter.
[[nodiscard]] renderer::Mesh bolt(float size_m);
/// `count` places on a circle in the plane y = 0, each turned with it.
[[nodiscard]] std::vector<glm::mat4> around(int count, float radius_m, float first_rad = 0.0F);
/// A straight bar of any profile (counter-clockwise in x and y) from z0 to z1.
[[nodiscard]] renderer::Mesh extrude(std::span<const glm::vec2> profile, float z0_m, float z1_m,
                                     float crease_rad = 0.6F);
/// A flat rectangle in cells of at most `cell_m`; the outside is cross(edge_u, edge_v), and v of
/// its uv runs against edge_v, so that v goes down on walls.
[[nodiscard]] renderer::Mesh rectangle(const glm::vec3& origin_m, const glm::vec3& edge_u_m,
                                       const glm::vec3& edge_v_m, float cell_m = 0.3F);
/// A ring of round section about +Y in the plane y = 0.
[[nodiscard]] renderer::Mesh ring(float radius_m, float thick_m, int around_segments,
                                  int section_segments = 8);

}  // namespace obscura::stimuli
