// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "analysis/image_error/accessibility_error.h"
#include "app/explorer/shot.h"
#include "app/explorer/truth.h"

namespace obscura::app::explorer {

/// A rectangle of an image in pixels, from its upper left corner.
struct Region {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
    [[nodiscard]] bool operator==(const Region&) const = default;
};
/// What of it lies in an image of that size; nothing where none does.
[[nodiscard]] std::optional<Region> within(const Region& region, int width, int height);

/// How far a side's accessibility is from the truth, over surfaces that a ray has reached.
struct Comparison {
    static constexpr int kBins = 41;

    analysis::AccessibilityError error;
    /// Root of the mean square of the truth's own standard errors there: what an exact technique
    /// would show for an RMSE.
    double truth_rmse = 0.0;
    /// What is left of the RMSE without it; 0 where the truth's is the larger.
    double rmse_without_truths = 0.0;
    std::array<float, kBins> histogram{};  ///< shares of the pixels, errors from -1 to 1
};

/// Over the region, or all of the image. `truth` is of the shot's size.
[[nodiscard]] analysis::Possible<Comparison> compare(const Shot& shot, const Truth& truth,
                                                     const std::optional<Region>& region);

}  // namespace obscura::app::explorer
