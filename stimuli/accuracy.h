// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "renderer/reference/reference.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// How far the accessibility of an image is from the ray-traced truth of its view.
struct Accuracy {
    double rmse = 0.0;      ///< of accessibility, [0, 1]
    double bias = 0.0;      ///< mean of the image's less the truth's: negative is too dark
    double radius_m = 0.0;  ///< within which the truth's rays look for occluders
    int pixels = 0;         ///< with a surface, that were compared

    bool operator==(const Accuracy&) const = default;
};

/// Two images whose errors differ by a smaller share of the larger one have no order: the patches
/// that they are wrong in, not how wrong they are, would decide between them.
inline constexpr double kLeastOrder = 0.1;

/// The radius that the pair's truth is asked for: that of b, else of a; nothing where neither
/// technique has a `radius_m`.
[[nodiscard]] std::optional<double> truth_radius_m(const Condition& condition);

/// The truth at every so many columns and rows of an image, from its lower left corner.
struct SparseTruth {
    int width = 0;  ///< of the whole image
    int height = 0;
    int step = 1;  ///< odd, so that each place of a 4 x 4 tile of noise is met alike
    double radius_m = 0.0;
    renderer::ReferenceImage image;

    /// Which pixel of the whole image, upper row first, one of `image` is.
    [[nodiscard]] std::size_t whole_pixel(int x, int y) const {
        const int row = height - 1 - step * (image.height - 1 - y);
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(step * x);
    }
};

/// Traces about 8,000 pixels of an image of that size with 256 rays each: a second or two.
[[nodiscard]] SparseTruth sparse_truth(const renderer::ReferenceScene& scene,
                                       const renderer::Camera& camera, int width, int height,
                                       double radius_m);

/// `accessibility` has one value a pixel of the whole image, upper row first. Nothing where the
/// camera sees no surface.
[[nodiscard]] std::optional<Accuracy> accuracy_of(const std::vector<float>& accessibility,
                                                  const SparseTruth& truth);

}  // namespace obscura::stimuli
