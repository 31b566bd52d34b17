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

/// Tests each by participants. The tally knows who voted.
void test_participants(std::vector<HypothesisResult>& hypotheses, const Tally& tally);

/// Fills HypothesisResult::interval and equality_interval; needs the resampled one where there is
/// one.
void choose_intervals(std::vector<HypothesisResult>& hypotheses, const Tally& tally);

/// The p-value that a verdict on the hypothesis rests on: of participants where they are known (1
/// where each of them chose both sides equally often), else the exact
/// binomial one of the counts.
[[nodiscard]] Possible<PValue> p_of(const HypothesisResult& result);

/// That test in words, with its numbers.
[[nodiscard]] std::string test_words(const HypothesisResult& result);

}  // namespace obscura::analysis
