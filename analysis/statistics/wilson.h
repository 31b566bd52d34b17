// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/interval.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Wilson's score interval of a share (E. B. Wilson 1927), without continuity correction.
/// `successes` 0 to `n`, `n` 0 to 2 kMaxCount, `confidence` strictly between 0 and 1: throws bad
/// input otherwise. No value for n = 0.
[[nodiscard]] Possible<Interval> wilson(std::int64_t successes, std::int64_t n,
                                        double confidence = 0.95);

/// The same for a share (0 to 1) of n that need not be a whole number of successes.
[[nodiscard]] Possible<Interval> wilson_of_share(double share, std::int64_t n,
                                                 double confidence = 0.95);

}  // namespace obscura::analysis
