// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// A verdict on every hypothesis of the family, and on the question about validity where it is
/// asked, by verdict_rule(). Needs hypotheses and validity of the analysis.
[[nodiscard]] std::vector<Verdict> verdicts_of(const Analysis& analysis);

/// What an interval of the share of B says of shares at least `margin` from one half. An end is
/// taken as it is shown, to a tenth of a per cent.
struct ShareReach {
    bool for_b = false;  ///< a share of B of 1/2 + margin or more lies in it
    bool for_a = false;  ///< one of 1/2 - margin or less does
};
[[nodiscard]] ShareReach reach_of(const Interval& interval, double margin);

/// Whether an interval of a difference between two levels holds one of `margin` or more, either
/// way. An end is taken as it is shown, to a tenth of a point.
[[nodiscard]] bool reaches_difference(const Interval& interval, double margin);

/// Conclusions that differ between the analysis and that of everybody, each in a sentence.
[[nodiscard]] std::vector<std::string> changed_conclusions(const Analysis& analysis,
                                                           const Analysis& everybody);

}  // namespace obscura::analysis
