// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// The tests over conditions that show the same two variants, each at a level of its own, by the
/// participants who answered every one of them once. No value, with the reason, when only counts
/// are known, when two conditions share a level, when a participant answered a condition more than
/// once, and when nobody answered all.
[[nodiscard]] Possible<SameParticipants> same_participants(
    const std::vector<const ConditionVotes*>& conditions);

}  // namespace obscura::analysis
