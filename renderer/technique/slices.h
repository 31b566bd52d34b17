// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/technique/noise.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {

// What techniques that march through the image along slices share (technique/slices.glsl).

/// The place of a pixel's first slice: cosine and sine of its angle in the image, and how far its
/// samples are moved along it, from 0 to 1 of a step.
struct Turn {
    float cosine;
    float sine;
    float jitter;
};

/// The tile of turns where `sector_rad` lies between neighbouring directions: of Variant::noise,
/// 4x4 with sixteen angles and as many jitters, evenly spread in both (a Hammersley set), or those
/// of noise_tile().
[[nodiscard]] Tile<Turn> turn_tile(double sector_rad, std::string_view noise = "tile4x4");
[[nodiscard]] NumberTable turn_table(double sector_rad, std::string_view noise);

/// Directions of the image that a pixel's samples lie along, evenly apart.
struct Fan {
    int count = 1;
    double sector_rad = 0.0;  ///< between neighbours
    int steps = 4;            ///< samples on one side
};
/// Slices, whose samples lie on both sides of the pixel, and directions, with one side only, of the
/// variant's `steps` on each side.
[[nodiscard]] Fan fan_of_slices(const Variant& variant);
[[nodiscard]] Fan fan_of_directions(const Variant& variant);

/// The turns of a fan from its first direction to each.
[[nodiscard]] std::vector<Turn> fan_turns(const Fan& fan);

/// One step: a fetch of the depth for each sample, and the pixel's own depth, normal and turn. The
/// shader reads the tile `turns`, and the defines FAN_COUNT, FAN_STEPS and FAN_TURNS, an array of
/// vec2.
[[nodiscard]] Recipe fan_recipe(const Variant& variant, const std::string& shader, const Fan& fan);

/// The samples on one side of a slice.
[[nodiscard]] Parameter slice_steps();
/// `radius_m`, which only sets units, and how far samples reach in it.
[[nodiscard]] Parameter slice_radius();
[[nodiscard]] Parameter slice_reach(double standard);
/// How samples lie along a side, and the exponent of what is found.
[[nodiscard]] Parameter slice_spread(double standard);
[[nodiscard]] Parameter slice_power();

/// Why such a technique does not see what lies outside the image.
[[nodiscard]] std::map<Ideal, std::string> slice_nature();

}  // namespace obscura::renderer
