// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Two-sided exact binomial test by the method of small p-values: the probability of all outcomes
/// no more likely than the one met, as R's binom.test (R Core Team; it counts as ties what is
/// within a factor of 1 + 1e-7). Fast at any count: tails are distribution functions, and the far
/// tail's edge is found by bisection.
/// `successes` 0 to `n`, `n` 0 to 2 kMaxCount, `share` strictly between 0 and 1: throws bad input
/// otherwise. No value for n = 0.
[[nodiscard]] Possible<PValue> exact_binomial(std::int64_t successes, std::int64_t n,
                                              double share = 0.5);

/// The same against one half for a share (0 to 1) of `n` that need not be a whole number of
/// successes, as of n participants with several votes each: twice the tail, which
/// clopper_pearson_of_share() turns round; the two never contradict each other.
[[nodiscard]] Possible<PValue> exact_binomial_of_share(double share, std::int64_t n);

}  // namespace obscura::analysis
