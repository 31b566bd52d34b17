// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/chi_square.h"

namespace obscura::analysis {

/// Below this number of changed answers the exact test is the one to read.
inline constexpr std::int64_t kFewDiscordant = 25;

/// Whether a share differs between two conditions that the same participants answered
/// (Q. McNemar 1947). Only those who changed their answer say something.
struct McNemarTest {
    std::int64_t discordant = 0;
    ChiSquareTest uncorrected;  ///< (b - c)^2 / (b + c)
    ChiSquareTest corrected;    ///< with A. L. Edwards' continuity correction (1948)
    PValue exact;               ///< two-sided binomial test of the changed answers

    [[nodiscard]] bool is_exact_better() const { return discordant < kFewDiscordant; }
    /// The exact p for few changed answers, that of the uncorrected chi-square for many.
    [[nodiscard]] const PValue& p() const { return is_exact_better() ? exact : uncorrected.p; }
};

/// `changed.a` participants changed their answer one way and `changed.b` the other. No value when
/// nobody did. Throws bad input for counts outside 0 to kMaxCount.
[[nodiscard]] Possible<McNemarTest> mcnemar(const Votes& changed);

}  // namespace obscura::analysis
