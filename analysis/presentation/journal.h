// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// `44.4 %`, and an interval of shares or of differences in points: `29.5 to 60.4 %`,
/// `-3.2 to +14.1 points`.
[[nodiscard]] std::string journal_share(double share);
[[nodiscard]] std::string journal_interval(const Interval& interval);
[[nodiscard]] std::string journal_points(const Interval& interval);

/// What a verdict says with its numbers in one line, without its name: `undecided; B in 46 of 108
/// votes (42.6 %, 95 % CI 33.4 to 52.3 %), p = .392, corrected p = .783`; of validity with each of
/// its comparisons. Every number is the analysis's own.
[[nodiscard]] std::string verdict_line(const Analysis& analysis, const Verdict& verdict);

}  // namespace obscura::analysis
