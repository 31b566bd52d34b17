// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// How many times likelier the votes are when the share may be anything (a flat prior) than when it
/// is one half: above 1 speaks for a preference, below 1 against one.
struct BayesFactor {
    /// BF10; nothing where it is larger than a double can be.
    Possible<double> bf10 = Possible<double>::none("larger than a double can be");
    double log10_bf10 = 0.0;
};

/// BF10 = 2^n / ((n + 1) C(n, successes)) (H. Jeffreys 1961, section 5.1). `successes` 0 to `n`,
/// `n` 0 to 2 kMaxCount: throws bad input otherwise. No value for n = 0.
[[nodiscard]] Possible<BayesFactor> bayes_factor(std::int64_t successes, std::int64_t n);

}  // namespace obscura::analysis
