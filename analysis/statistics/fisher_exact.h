// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Whether the share of B is the same in two rows of votes, exactly (R. A. Fisher 1935), two-sided
/// by the method of small p-values as R's fisher.test: the probability, with all sums held fixed,
/// of every table no more likely than the one met (ties within a factor of 1 + 1e-7).
/// No value when a row has no votes or all votes are for one side. Throws bad input for counts
/// outside 0 to kMaxCount.
[[nodiscard]] Possible<PValue> fisher_exact(const Votes& one, const Votes& other);

}  // namespace obscura::analysis
