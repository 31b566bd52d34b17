// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace obscura::renderer {

struct SeenBuffers;
struct Variant;

/// What a definition gives one pixel, and what single precision may make of it: rounding, and each
/// decision (which texel, which side of a threshold) that lies within rounding either way.
struct Admitted {
    double value = 1.0;  ///< in double precision
    double low = 1.0;    ///< low <= value <= high
    double high = 1.0;
    int depth_reads = 0;  ///< look-ups of the depth buffer beside the pixel's own
};

/// A technique's definition written out a second time, in double precision, on the buffers that its
/// shader reads: what the shader is held against. Made once for an image, then asked for surfaces;
/// x from the left, y from the bottom, as OpenGL counts. The buffers must outlive it; several
/// threads may ask at a time.
using PixelModel = std::function<Admitted(int x, int y)>;
using Model = std::function<PixelModel(const SeenBuffers& buffers, const Variant& variant)>;

/// The same of a denoise filter: the whole image from the accessibility before it; both upper row
/// first.
using DenoiseModel = std::function<std::vector<Admitted>(const SeenBuffers& buffers,
                                                         std::span<const float> accessibility)>;

}  // namespace obscura::renderer
