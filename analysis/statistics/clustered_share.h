// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/interval.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// An interval, 0 to 1, of the share of B in votes that come several from each participant: a
/// ratio of two sums over participants, with the variance between them (W. G. Cochran 1977,
/// Sampling Techniques, section 2.11) and Student's t. Where all gave as many votes it is t's
/// interval of the mean of their own shares. `each`: the votes of each participant; those without
/// are passed over. No value for fewer than two of them, and where nobody differs from the others:
/// such votes say nothing of how participants vary. Throws bad input for counts outside 0 to
/// kMaxCount and a confidence that is not strictly between 0 and 1.
[[nodiscard]] Possible<Interval> clustered_share(const std::vector<Votes>& each,
                                                 double confidence = 0.95);

}  // namespace obscura::analysis
