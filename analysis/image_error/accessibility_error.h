// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// How far an accessibility buffer is from the truth, in linear accessibility (1 = open), over the
/// pixels that count. The measures are those of every such comparison: root mean square, signed
/// mean, mean absolute value, the 99th percentile of the absolute value, and the peak
/// signal-to-noise ratio -20 log10(rmse) for a peak of 1.
struct AccessibilityError {
    double rmse = 0.0;
    double bias = 0.0;  ///< mean of measured - truth: negative is too dark
    double mae = 0.0;
    double p99 = 0.0;
    Possible<double> psnr_db = 0.0;  ///< none where there is no error at all
    std::size_t pixels = 0;          ///< that counted and were finite
    std::size_t nonfinite = 0;       ///< NaN and infinities of the whole buffer
};

/// Compares `measured` with `truth` where `counted` is not 0; all three have one value a pixel.
/// What is not finite is counted, over the whole buffer, and takes no part in the other numbers.
/// Without a pixel to compare there is no error: reason in place of the value. Throws bad input for
/// lengths that differ.
[[nodiscard]] Possible<AccessibilityError> accessibility_error(
    std::span<const float> measured, std::span<const float> truth,
    std::span<const std::uint8_t> counted);

/// 1 for pixels at least `margin` (a fraction of width and height, [0, 0.5)) away from the border,
/// else 0; one value a pixel, row by row. For errors without what a screen-space technique cannot
/// see beyond the image.
[[nodiscard]] std::vector<std::uint8_t> interior_mask(int width, int height, double margin);

}  // namespace obscura::analysis
