// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// A p-value as journals print it (APA 7, 6.36), without its name: three decimals and no zero
/// before the point, `.031`; `< .001`, `> .999`.
[[nodiscard]] std::string journal_p(const PValue& p);
[[nodiscard]] std::string journal_p(const Possible<double>& p);  ///< `none` where there is none
/// With its name: `p = .031`, `p < .001`.
[[nodiscard]] std::string journal_p_words(const PValue& p);

/// `44.4 %`, and an interval of shares or of differences in points: `29.5 to 60.4 %`,
/// `-3.2 to +14.1 points`.
[[nodiscard]] std::string journal_share(double share);
[[nodiscard]] std::string journal_interval(const Interval& interval);
[[nodiscard]] std::string journal_points(const Interval& interval);

/// What a verdict says with its numbers in one line, without its name: `undecided; B in 46 of 108
/// votes (42.6 %, 95 % CI 33.4 to 52.3 %), p = .392, corrected .783`. Every number is the
/// analysis's own.
[[nodiscard]] std::string verdict_line(const Analysis& analysis, const Verdict& verdict);

}  // namespace obscura::analysis
