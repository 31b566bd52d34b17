// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/chi_square.h"

namespace obscura::analysis {

/// The votes of one condition by the order of showing.
struct OrderStratum {
    Votes b_second;  ///< votes where B was shown second
    Votes b_first;   ///< votes where B was shown first
};

/// Logistic regression of the choice with a term for each condition and one for the order:
/// logit P(B) = c_condition + order_term (B shown second), - order_term (B shown first).
struct OrderBiasTest {
    double order_term = 0.0;  ///< log odds of choosing the second of two equally liked images
    double standard_error = 0.0;
    double second_share = 0.5;       ///< the same as a share, 0 to 1
    ChiSquareTest likelihood_ratio;  ///< against the model without the order term, df 1
    int conditions = 0;              ///< that say something about the order
};

/// Maximum likelihood by Newton's method (P. McCullagh and J. A. Nelder 1989, section 4.4), linear
/// in the number of conditions. Conditions shown in one order only, or with all votes for one side,
/// say nothing and are left out. No value when none is left, or when the votes are separated: no
/// finite order term is likeliest then. Throws bad input for counts outside 0 to kMaxCount.
[[nodiscard]] Possible<OrderBiasTest> order_bias(const std::vector<OrderStratum>& conditions);

}  // namespace obscura::analysis
