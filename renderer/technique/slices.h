// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

// What techniques that march through the image along slices share (technique/slices.glsl).

/// Samples on one side of a slice.
inline constexpr int kSliceSteps = 4;

/// The place of a pixel's first slice: cosine and sine of its angle in the image, and how far its
/// samples are moved along it, from 0 to 1 of a step.
struct Turn {
    float cosine;
    float sine;
    float jitter;
};

/// The 4x4 tile of turns where `sector_rad` lies between neighbouring directions: sixteen angles
/// and as many jitters, evenly spread in both (a Hammersley set). Row by row.
[[nodiscard]] std::vector<Turn> turn_tile(double sector_rad);
[[nodiscard]] NumberTable turn_table(double sector_rad);

/// The turns from the first direction to each, `count` in all, `sector_rad` apart.
[[nodiscard]] std::vector<Turn> direction_turns(int count, double sector_rad);

/// The same as a define of that name, an array of vec2.
[[nodiscard]] std::string direction_define(const std::string& name, int count, double sector_rad);

/// `radius_m`, which only sets units, and how far samples reach in it.
[[nodiscard]] Parameter slice_radius();
[[nodiscard]] Parameter slice_reach(double standard);

/// Why such a technique does not see what lies outside the image.
[[nodiscard]] std::map<Ideal, std::string> slice_nature();

}  // namespace obscura::renderer
