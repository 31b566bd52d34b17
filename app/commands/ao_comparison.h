// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/image_error/accessibility_error.h"
#include "app/commands/ao_buffer.h"

namespace obscura::app {

/// What accessibility buffers are held against.
struct AoTruth {
    std::string file;       ///< OpenEXR with a channel ao.Y; empty: ray traced for each
    int rays = 256;         ///< a pixel, of a traced one
    double radius_m = 0.0;  ///< of a traced one, for what has no radius of its own
};

/// How far one buffer is from the truth.
struct AoComparison {
    std::string camera;
    std::string variant;
    std::string truth;          ///< in words, with its radius
    double truth_stderr = 0.0;  ///< root mean square over the surfaces; 0: not known
    analysis::Possible<analysis::AccessibilityError> surfaces = analysis::AccessibilityError{};
    /// The same without a tenth of the image at each side.
    analysis::Possible<analysis::AccessibilityError> inside = analysis::AccessibilityError{};
    int width = 0;
    int height = 0;
    std::vector<float> difference;  ///< measured - truth; 0 where there is no surface
    std::vector<std::uint8_t> is_surface;
    std::vector<std::string> notes;  ///< what makes the two hard to compare, a sentence each
    std::vector<std::filesystem::path> files;  ///< that were written of it
};

/// Compares over the pixels that show a surface, since empty ones are 1 in both. Throws bad input
/// for a file that is no such image, of another size, scene or camera.
[[nodiscard]] AoComparison compare_ao(AoBuffers& buffers, const renderer::Camera& camera,
                                      const renderer::Variant& variant,
                                      const renderer::FloatImage& measured, const AoTruth& truth);

/// STEM-difference.exr, channel difference.Y, and STEM-difference.png: orange is too dark, white
/// right, blue too light, at +-0.5 and beyond the full colour; black shows no surface.
void write_difference(const std::string& stem, AoComparison& comparison);

/// One line a buffer: RMSE, bias, MAE and p99 over surfaces and inside.
[[nodiscard]] std::string comparison_table(const std::vector<AoComparison>& comparisons);

/// The same as a JSON array.
[[nodiscard]] std::string comparison_json(const std::vector<AoComparison>& comparisons);

}  // namespace obscura::app
