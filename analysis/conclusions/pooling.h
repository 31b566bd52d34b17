// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// What A and B mean in all of the conditions, one or more, so that their votes can be added up:
/// - the two variants, where all compare the same two;
/// - without and with ambient occlusion, where all compare something with None;
/// - the less and the more accurate, where every pair's two variants stand at different places in
///   the order that the thesis assumes (assumed_rank(), then samples).
/// Otherwise no value: B would be another thing in each condition.
[[nodiscard]] Possible<Pooling> pooling_of(const std::vector<const ConditionVotes*>& conditions);

}  // namespace obscura::analysis
