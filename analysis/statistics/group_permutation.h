// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Whether two groups of participants gave different numbers, one each.
struct GroupPermutation {
    PValue p;              ///< two-sided
    bool is_exact = true;  ///< over all ways to part them; else by the normal approximation
};

/// The share of all ways to part the participants into groups of these sizes in which the sum of
/// the first group is at least as far from what is expected (R. A. Fisher 1935, E. J. G. Pitman
/// 1937). No value where a group is empty and where all numbers are the same. Throws bad input for
/// a number below 0 or beyond a million.
[[nodiscard]] Possible<GroupPermutation> group_permutation(const std::vector<std::int64_t>& one,
                                                           const std::vector<std::int64_t>& other);

}  // namespace obscura::analysis
