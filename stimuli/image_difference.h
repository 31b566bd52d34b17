// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "stimuli/png.h"

namespace obscura::stimuli {

/// The colour difference that half of all observers just notice between two large patches: 2.3 in
/// CIELAB (Mahy, Van Eycken & Oosterlinck 1994, "Evaluation of Uniform Color Spaces Developed after
/// the Adoption of CIELAB and CIELUV", Color Research & Application 19(2)).
inline constexpr double kJustNoticeable_delta_e = 2.3;

/// Below this sum of visible differences nobody can tell two images apart: 0.0001 of the image by
/// one just-noticeable difference, or less of it by more. Of an image that fills 45 by 25 degrees
/// that is a third of a degree square. A small spot needs more contrast than a patch: threshold
/// times area stays the same (Ricco's law, Wyszecki & Stiles 1982, "Color Science", 7.3).
inline constexpr double kLeastVisible = 1e-4;

/// Below this sum most observers of a pair will guess; what an attention check shows must be
/// kObvious or more.
inline constexpr double kHardlyVisible = 10.0 * kLeastVisible;
inline constexpr double kObvious = 100.0 * kLeastVisible;

/// How far two images are apart, seen as sRGB under D65.
struct ImageDifference {
    double differing = 0.0;        ///< share of pixels that are not the same, [0, 1]
    double over_threshold = 0.0;   ///< share of pixels at least kJustNoticeable_delta_e apart
    double visible = 0.0;          ///< the same, each pixel counted once for each such difference
    double largest_delta_e = 0.0;  ///< of any pixel, in CIELAB (CIE 1976)

    bool operator==(const ImageDifference&) const = default;
    [[nodiscard]] bool none() const { return differing == 0.0; }
    [[nodiscard]] bool can_be_seen() const { return visible >= kLeastVisible; }
};

/// Throws bad input for images of different sizes or without pixels.
[[nodiscard]] ImageDifference difference_of(const RgbImage& a, const RgbImage& b);

/// How bright an image is, by the luminance of its pixels as a share of display white.
struct Brightness {
    double mean = 0.0;  ///< [0, 1]
    /// Standard deviation over mean, which an exposure leaves as it is (Frazor & Geisler 2006,
    /// "Local luminance and contrast in natural images", Vision Research 46); 0 for a black image.
    double contrast = 0.0;
};

/// Throws bad input for an image without pixels.
[[nodiscard]] Brightness brightness_of(const RgbImage& image);

}  // namespace obscura::stimuli
