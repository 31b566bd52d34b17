// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/quartiles.h"

namespace obscura::analysis {

/// An interval of the share of B in `other` less that in `one`, -1 to 1, from the score intervals
/// of the two (R. G. Newcombe 1998, Statistics in Medicine 17, 873, method 10), as if different
/// people had voted. No value when one of them has no votes. Throws bad input for counts outside 0
/// to kMaxCount and a confidence that is not strictly between 0 and 1.
[[nodiscard]] Possible<Interval> share_difference(const Votes& one, const Votes& other,
                                                  double confidence = 0.95);

}  // namespace obscura::analysis
