// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "renderer/recipe/recipe.h"
#include "renderer/technique/variant.h"

namespace obscura::renderer {

/// The 4x4 tile of unit vectors that turns every pixel's samples another way; seeded, always the
/// same. Row by row.
[[nodiscard]] std::vector<glm::vec3> rotation_tile();

/// `count` points in the unit ball for `blizzard` and `raymarch`: directions spread evenly over the
/// sphere (spherical Fibonacci points), lengths spread evenly from 1/2 to 1.
[[nodiscard]] std::vector<glm::vec3> ball_kernel(int count);

/// The same as tables of a recipe: `rotations` of kTileSize x kTileSize, `kernel` of count x 1.
[[nodiscard]] NumberTable rotation_table();
[[nodiscard]] NumberTable ball_table(int count);

/// A step that writes accessibility by a shader that ends in passes/accessibility.glsl, with the
/// number of samples as the define SAMPLES.
[[nodiscard]] Step accessibility_step(const Variant& variant, const std::string& shader,
                                      const std::vector<Read>& reads, int fetches);

}  // namespace obscura::renderer
