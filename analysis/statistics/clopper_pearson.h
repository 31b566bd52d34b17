// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/possible.h"
#include "analysis/statistics/wilson.h"

namespace obscura::analysis {

/// The exact interval of a share (C. J. Clopper and E. S. Pearson 1934): it covers the true share
/// at least as often as it says, and is wider than Wilson's for that.
/// `successes` 0 to `n`, `n` 0 to 2 kMaxCount, `confidence` strictly between 0 and 1: throws bad
/// input otherwise. No value for n = 0.
[[nodiscard]] Possible<Interval> clopper_pearson(std::int64_t successes, std::int64_t n,
                                                 double confidence = 0.95);

/// The same for a share (0 to 1) of n that need not be a whole number of successes, as of n
/// participants with several votes each: the ends follow the share without steps.
[[nodiscard]] Possible<Interval> clopper_pearson_of_share(double share, std::int64_t n,
                                                          double confidence = 0.95);

}  // namespace obscura::analysis
