// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// Of conditions that show the same two variants at two levels, in scenes that each show both. Of
/// participants who answered every condition once the difference is a whole number, c times the
/// mean over scenes of (share of B at the second level less that at the first), with c the least
/// common multiple of the numbers of conditions, and the test exact; where somebody answered one
/// more than once, or most did not answer all, everybody counts with the scenes that he saw at both
/// levels, and the test is that of large samples. `first`: the earlier level. No value, with the
/// reason, where only counts are known, and when nobody answered at both levels of a scene.
[[nodiscard]] Possible<LevelContrast> level_contrast(
    const std::vector<const ConditionVotes*>& conditions, const std::string& first);

}  // namespace obscura::analysis
