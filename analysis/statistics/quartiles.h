// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/interval.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// The values that part a sample into four, in its unit.
struct Quartiles {
    std::int64_t n = 0;
    double first = 0.0;
    double median = 0.0;
    double third = 0.0;
};

/// Sorts the sample. No value for an empty one. Throws bad input for values that are not finite.
[[nodiscard]] Possible<Quartiles> quartiles(std::vector<double>& sample);

/// An interval of the median of what the sorted sample was drawn from, without an assumption on its
/// shape: the order statistics that the binomial distribution gives (H. A. David and H. N. Nagaraja
/// 2003, section 7.1); it covers at least as often as it says. No value for a sample too small.
/// `confidence` strictly between 0 and 1: throws bad input otherwise.
[[nodiscard]] Possible<Interval> median_interval(const std::vector<double>& sorted,
                                                 double confidence = 0.95);

/// The median slope between two points of a line of y over x (H. Theil 1950, P. K. Sen 1968), which
/// a few wild points do not move: over all pairs of up to kMostPaired points, beyond that over each
/// point with the one half the sample further on (Theil's incomplete method), so that the cost
/// stays linear. No value when no two x differ. `points` are x and y, finite, in order of x.
inline constexpr std::size_t kMostPaired = 20;
[[nodiscard]] Possible<double> median_slope(const std::vector<std::pair<double, double>>& points);

}  // namespace obscura::analysis
