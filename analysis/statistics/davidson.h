// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/interval.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Answers to a pair of which one may be that there is no difference; each 0 to kMaxCount.
struct TiedVotes {
    std::int64_t a = 0;
    std::int64_t b = 0;
    std::int64_t none = 0;

    [[nodiscard]] std::int64_t n() const { return a + b + none; }
};

/// Davidson's model of one pair (R. R. Davidson 1970, JASA 65, equations 2.3 and 2.4): P(B) =
/// w_B / (w_A + w_B + nu sqrt(w_A w_B)), P(none) = nu sqrt(w_A w_B) / the same. Of one pair it fits
/// exactly, so its estimates by maximum likelihood are closed forms.
struct DavidsonPair {
    double log_odds = 0.0;          ///< ln(w_B / w_A) = ln(b / a)
    double standard_error = 0.0;    ///< sqrt(1 / a + 1 / b)
    double nu = 0.0;                ///< none / sqrt(a b); 0: nobody saw none
    double share_b = 0.5;           ///< w_B / (w_A + w_B)
    Interval interval;              ///< of that, from the log odds and their standard error
    double likelihood_ratio = 0.0;  ///< statistic of w_A = w_B, df 1
    PValue p;                       ///< of that by chi-square
};

/// No value where nobody chose A or nobody chose B: the odds have no end then. Throws bad input for
/// counts outside 0 to kMaxCount and a confidence that is not strictly between 0 and 1.
[[nodiscard]] Possible<DavidsonPair> davidson_pair(const TiedVotes& votes,
                                                   double confidence = 0.95);

/// The share of B with half a vote to each for every answer without a difference.
struct SplitShare {
    double share_b = 0.5;
    Interval interval;  ///< Wilson's of that share: answers without a difference vary less
    PValue p;           ///< exact sign test: of those who saw a difference, as many for each
};

/// No value where nobody saw a difference. Throws as the other.
[[nodiscard]] Possible<SplitShare> split_share(const TiedVotes& votes, double confidence = 0.95);

}  // namespace obscura::analysis
