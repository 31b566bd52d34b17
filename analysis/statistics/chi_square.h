// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// P(X >= statistic) of the chi-square distribution with `df` degrees of freedom.
/// `statistic` >= 0 and finite, `df` >= 1; throws bad input otherwise.
[[nodiscard]] PValue chi_square_tail(double statistic, int df);

/// Pearson's test (K. Pearson 1900), without continuity correction.
struct ChiSquareTest {
    double statistic = 0.0;
    int df = 1;
    PValue p;
};

/// Goodness of fit to an equal split of the votes, df 1: (a - b)^2 / (a + b). No value without
/// votes. Throws bad input for counts outside 0 to kMaxCount.
[[nodiscard]] Possible<ChiSquareTest> chi_square_equal_split(const Votes& votes);

/// Whether the share of B is the same in all rows, df rows - 1. Rows without votes are left out;
/// no value with fewer than two rows left, or when all votes are for one side. Throws bad input for
/// counts outside 0 to kMaxCount.
[[nodiscard]] Possible<ChiSquareTest> chi_square_homogeneity(const std::vector<Votes>& rows);

}  // namespace obscura::analysis
