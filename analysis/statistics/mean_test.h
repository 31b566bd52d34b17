// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/statistics/interval.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// The mean of what participants gave, one number each, by Student's t (W. S. Gosset 1908).
struct MeanTest {
    std::int64_t n = 0;
    double mean = 0.0;
    double standard_error = 0.0;
    PValue p;           ///< two-sided, of a mean of 0
    Interval interval;  ///< of the mean
};

/// No value for fewer than two numbers, and where all are the same: they then say nothing of how
/// participants vary. Throws bad input for a number that is not finite and a confidence that is not
/// strictly between 0 and 1.
[[nodiscard]] Possible<MeanTest> mean_test(const std::vector<double>& values,
                                           double confidence = 0.95);

}  // namespace obscura::analysis
