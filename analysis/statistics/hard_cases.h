// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace obscura::analysis {

/// One number of a statistic where it is known or where formulas break, against what it must be.
struct StatisticsCase {
    std::string name;
    std::string quantity;
    double expected = 0.0;
    double measured = 0.0;   ///< finite; 1 or 0 for what is or is not said
    double tolerance = 0.0;  ///< largest difference that holds
    bool holds = false;
    std::string note;  ///< where the expected value is from
};

/// The hard cases of the statistics: published anchors, tails beyond doubles, counts to a billion,
/// zero cells, ties, separation. Takes milliseconds.
[[nodiscard]] std::vector<StatisticsCase> statistics_hard_cases();

}  // namespace obscura::analysis
