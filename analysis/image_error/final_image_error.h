// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace obscura::analysis {

/// How far a final image is from the one with true accessibility. Code values are sRGB (IEC
/// 61966-2-1), differences are of code / 255.
struct FinalImageError {
    double rmse = 0.0;        ///< OpenImageIO's compare, over the three channels
    double max = 0.0;         ///< the largest difference of a channel
    double yee_failed = 0.0;  ///< share of pixels that differ visibly by Yee's metric, [0, 1]
};

/// Where and how an image is looked at, for Yee's metric (Yee 2004, "A Perceptual Metric for
/// Production Testing").
struct Viewing {
    double luminance_cd_m2 = 100.0;      ///< of display white
    double horizontal_field_deg = 45.0;  ///< that the image fills
};

/// Compares two images of width x height x 3 code values by OpenImageIO. Throws bad input for sizes
/// that do not fit, failure with OpenImageIO's reason.
[[nodiscard]] FinalImageError final_image_error(std::span<const std::uint8_t> image,
                                                std::span<const std::uint8_t> truth, int width,
                                                int height, const Viewing& viewing = {});

}  // namespace obscura::analysis
