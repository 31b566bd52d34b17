// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/chi_square.h"

namespace obscura::analysis {

/// Whether a share differs between two conditions that the same participants answered
/// (Q. McNemar 1947). Only those who changed their answer say something. The exact test is the one
/// to read, whatever their number: that of the uncorrected chi-square rejects 7.6 % of true nulls
/// at .05 and 26 changes.
struct McNemarTest {
    std::int64_t discordant = 0;
    PValue exact;               ///< two-sided binomial test of the changed answers
    ChiSquareTest uncorrected;  ///< (b - c)^2 / (b + c)
    ChiSquareTest corrected;    ///< with A. L. Edwards' continuity correction (1948)
};

/// `changed.a` participants changed their answer one way and `changed.b` the other. No value when
/// nobody did. Throws bad input for counts outside 0 to kMaxCount.
[[nodiscard]] Possible<McNemarTest> mcnemar(const Votes& changed);

}  // namespace obscura::analysis
