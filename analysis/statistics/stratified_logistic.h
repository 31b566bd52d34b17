// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/chi_square.h"

namespace obscura::analysis {

/// Votes at one value of a predictor.
struct LogisticCell {
    double x = 0.0;  ///< finite
    Votes votes;
};

/// The votes of one condition.
using LogisticStratum = std::vector<LogisticCell>;

/// Logistic regression with a term for each stratum: logit P(B) = c_stratum + slope x.
struct StratifiedSlope {
    double slope = 0.0;  ///< log odds for each unit of x
    double standard_error = 0.0;
    ChiSquareTest likelihood_ratio;  ///< against slope 0, df 1
    int strata = 0;                  ///< that say something about the slope
};

/// Maximum likelihood by Newton's method (P. McCullagh and J. A. Nelder 1989, section 4.4), linear
/// in the number of cells. Strata with one value of x only, or with all votes for one side, say
/// nothing and are left out. No value when none is left, or when the votes are separated by x: no
/// finite slope is likeliest then. Throws bad input for counts outside 0 to kMaxCount and for an x
/// that is not finite.
[[nodiscard]] Possible<StratifiedSlope> stratified_slope(
    const std::vector<LogisticStratum>& strata);

}  // namespace obscura::analysis
