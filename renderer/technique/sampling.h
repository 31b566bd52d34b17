// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "renderer/recipe/recipe.h"
#include "renderer/technique/noise.h"
#include "renderer/technique/variant.h"

namespace obscura::renderer {

/// The tile of unit vectors that turns every pixel's samples another way: of Variant::noise, 4x4
/// random ones or those of noise_tile() on the sphere. Always the same.
[[nodiscard]] Tile<glm::vec3> rotation_tile(std::string_view noise = "tile4x4");

/// `count` points in the unit ball for `blizzard` and `raymarch`: directions spread evenly over the
/// sphere (spherical Fibonacci points), lengths spread evenly from 1/2 to 1.
[[nodiscard]] std::vector<glm::vec3> ball_kernel(int count);

/// The tile as a table of a recipe: `rotations`.
[[nodiscard]] NumberTable rotation_table(std::string_view noise);

/// A step's define that makes points constants of its program: FOR_EACH_POINT(DO) is DO(vec3(...))
/// for one after the other, to the last bit. What every pixel reads alike costs no texture read,
/// and no driver has to be trusted to unroll a loop.
[[nodiscard]] std::string points_define(const std::vector<glm::vec3>& points);

/// A step that writes accessibility by a shader that ends in passes/accessibility.glsl, with the
/// number of a frame's samples as the define SAMPLES, the side of its noise's tile as NOISE_SIZE,
/// and what passes/view.glsl reads of Variant::position.
[[nodiscard]] Step accessibility_step(const Variant& variant, const std::string& shader,
                                      const std::vector<Read>& reads, int fetches);

}  // namespace obscura::renderer
