// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// Whether the test alone, uncorrected, has p below .05; not where there is none.
[[nodiscard]] bool is_significant(const Possible<PValue>& p);

/// Every test of one set of votes.
[[nodiscard]] Preference preference_of(const Votes& votes);

/// The hypotheses of the family on a preference, in its order, from the votes alone.
[[nodiscard]] std::vector<HypothesisResult> test_hypotheses(
    const std::vector<ConditionResult>& conditions, const Family& family);

}  // namespace obscura::analysis
