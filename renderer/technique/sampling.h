// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace obscura::renderer {

/// The 4x4 tile of unit vectors that turns every pixel's samples another way; seeded, always the
/// same. Row by row.
[[nodiscard]] std::vector<glm::vec3> rotation_tile();

/// `count` points in the unit ball for `blizzard` and `raymarch`: directions spread evenly over the
/// sphere (spherical Fibonacci points), lengths spread evenly from 1/2 to 1.
[[nodiscard]] std::vector<glm::vec3> ball_kernel(int count);

}  // namespace obscura::renderer
