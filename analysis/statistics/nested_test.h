// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Whether terms that vary within participants belong in a model with an intercept for each.
struct NestedTest {
    double statistic = 0.0;     ///< likelihood ratio: twice the difference of the log likelihoods
    int df = 1;                 ///< the number of the terms
    std::int64_t error_df = 1;  ///< what is left within participants
    PValue p;
};

/// statistic / df under the F distribution with df and error_df, where the chi-square that it is in
/// the limit rejects too often at a few dozen participants. error_df = answers - participants - df,
/// the between-within way (M. D. Schluchter and J. D. Elashoff 1990; P. Li and D. T. Redden 2015
/// for binary answers). Throws bad input for a statistic that is negative or not finite, a df
/// below 1, and where error_df is below 1.
[[nodiscard]] NestedTest nested_test(double statistic, int df, std::int64_t answers,
                                     std::int64_t participants);

}  // namespace obscura::analysis
