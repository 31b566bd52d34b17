// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/chi_square.h"

namespace obscura::analysis {

/// Whether the share of yes is the same under all conditions when the same participants answered
/// each of them (W. G. Cochran 1950). `rows`: one for each participant, with one answer for each
/// condition. df = conditions - 1. Participants whose answers are all alike say nothing and change
/// nothing; no value when all are such, for fewer than two conditions and without participants.
/// Throws bad input when the rows differ in length.
[[nodiscard]] Possible<ChiSquareTest> cochran_q(const std::vector<std::vector<bool>>& rows);

/// What the test needs of the rows, for participants who are read one after another.
class CochranSums {
  public:
    explicit CochranSums(std::size_t conditions) : yes_(conditions) {}

    /// One participant: for each condition 1 (yes) or 0.
    void add(std::span<const signed char> row);

  private:
    friend Possible<ChiSquareTest> cochran_q(const CochranSums& sums);
    std::vector<std::int64_t> yes_;  ///< of each condition
    std::int64_t rows_ = 0;
    double mixed_ = 0.0;  ///< sum of L (k - L), which is 0 for answers all alike
};

/// The same test of what was added.
[[nodiscard]] Possible<ChiSquareTest> cochran_q(const CochranSums& sums);

}  // namespace obscura::analysis
