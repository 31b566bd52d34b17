// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

// What techniques that sample a disc of the image share (technique/disc.glsl).

/// A point of the unit disc.
struct DiscPoint {
    float x;
    float y;
};

/// `count` points that keep their distance from each other (Vogel 1979), as the papers' Poisson
/// discs do, at any number.
[[nodiscard]] std::vector<DiscPoint> disc_kernel(int count);

/// One step with the shader, which reads depth, normal and turns, and `reads_per_sample` texels for
/// each point of the disc.
[[nodiscard]] Recipe disc_recipe(const Variant& variant, const std::string& shader,
                                 int reads_per_sample);

// The definitions in double precision.
[[nodiscard]] PixelModel alchemy_model(const SeenBuffers& buffers, const Variant& variant);
[[nodiscard]] PixelModel homebrewed_model(const SeenBuffers& buffers, const Variant& variant);

}  // namespace obscura::renderer
