// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace obscura::analysis {

/// The q-quantile by linear interpolation between order statistics (Hyndman and Fan 1996, type 7).
/// `values` holds at least one finite value, q is in [0, 1].
[[nodiscard]] double quantile(std::vector<double> values, double q);

/// What is quoted of a list of times.
struct TimeSummary {
    double min_ms = 0.0;
    double median_ms = 0.0;
    double p95_ms = 0.0;
};

/// Of at least one time in milliseconds; all zero for none.
[[nodiscard]] TimeSummary summary_of(const std::vector<double>& times_ms);

}  // namespace obscura::analysis
