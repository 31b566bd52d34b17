// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/possible.h"
#include "analysis/statistics/wilson.h"

namespace obscura::analysis {

/// What is believed of a share after the votes, when every share was thought equally likely before
/// (T. Bayes 1763): a Beta(successes + 1, n - successes + 1) distribution.
struct Posterior {
    double mean = 0.5;
    Interval interval;  ///< with equal tails
    PValue above_half;  ///< P(share > 1/2)
};

/// `successes` 0 to `n`, `n` 0 to 2 kMaxCount, `confidence` strictly between 0 and 1: throws bad
/// input otherwise. No value for n = 0: there the posterior is the prior.
[[nodiscard]] Possible<Posterior> posterior_flat(std::int64_t successes, std::int64_t n,
                                                 double confidence = 0.95);

}  // namespace obscura::analysis
