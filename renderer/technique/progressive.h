// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

// Progressive ambient occlusion (Sunet 2018, 4.10): the kernel is spread over the variant's frames,
// each computes the accessibility of its own part, and what is shown is the mean of those so far.
// On a still image that is, after the last of them, the mean of all parts.

/// Every n-th group of `group` samples, from that of the variant's frame on: all where there is one
/// frame. Neighbours in a kernel lie far apart, so each part covers what the whole does.
template <typename Sample>
[[nodiscard]] std::vector<Sample> part_of(const std::vector<Sample>& kernel, const Variant& variant,
                                          int group = 1) {
    std::vector<Sample> part;
    for (std::size_t i = 0; i < kernel.size(); ++i) {
        const int turn = static_cast<int>(i) / group % frames_of(variant);
        if (turn == variant.frame) part.push_back(kernel[i]);
    }
    return part;
}

/// How many of the variant's samples a frame takes.
[[nodiscard]] int samples_of_frame(const Variant& variant);

/// Why the technique's kernel cannot be spread; empty where it can.
[[nodiscard]] std::string why_not_progressive(const Technique& technique);

/// What the technique computes in a frame, or in each of the variant's frames: then its last step
/// reads `history` and writes the mean. Empty for a technique without a recipe.
[[nodiscard]] Recipe recipe_of(const Technique& technique, const Variant& variant);

/// The definition in double precision, over all frames. The technique must have one.
[[nodiscard]] PixelModel model_of(const Technique& technique, const SeenBuffers& buffers,
                                  const Variant& variant);

}  // namespace obscura::renderer
