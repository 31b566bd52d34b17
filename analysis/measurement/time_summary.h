// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace obscura::analysis {

/// What is quoted of a list of times.
struct TimeSummary {
    double min_ms = 0.0;
    double median_ms = 0.0;
    double p95_ms = 0.0;
};

/// Of at least one time in milliseconds; all zero for none.
[[nodiscard]] TimeSummary summary_of(std::vector<double> times_ms);

}  // namespace obscura::analysis
