// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Whether differences of pairs lie about 0.
struct SignedRankTest {
    std::int64_t n = 0;      ///< differences other than 0
    std::int64_t zeros = 0;  ///< left out
    double positive = 0.0;   ///< V: sum of the ranks of differences above 0
    PValue p;                ///< two-sided
    bool is_exact = true;    ///< over all signs; else by the normal approximation
};

/// Up to so many differences the test is exact.
inline constexpr std::size_t kMostRanked = 200;

/// Wilcoxon's signed-rank test (F. Wilcoxon 1945). Differences of 0 are left out, and equal sizes
/// share the mean of their ranks; the distribution is that of all signs of those very ranks, so
/// that it is exact with ties too. Of more than kMostRanked differences the normal approximation
/// with the variance of those ranks and correction for continuity. Twice the smaller tail, at most
/// 1. No value where all are 0. Throws bad input for a difference that is not finite.
[[nodiscard]] Possible<SignedRankTest> signed_rank(const std::vector<double>& differences);

}  // namespace obscura::analysis
