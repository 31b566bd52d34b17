// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// How much is said: without the posterior and whether conditions differ, no verdict is another.
enum class PooledParts { kAll, kVerdict };

/// Says of each hypothesis with pooled votes what participants say, whose votes hang together: the
/// test, both intervals, the posterior and whether its conditions differ. What counts votes as
/// independent is taken from HypothesisResult::pooled where it would stand beside these.
void infer_pooled_shares(std::vector<HypothesisResult>& hypotheses, const Tally& tally,
                         PooledParts said = PooledParts::kAll);

/// The p-value that a verdict on the hypothesis rests on: of participants where they are known (1
/// where each of them chose both sides equally often), else of the counts as if each participant
/// had voted once.
[[nodiscard]] Possible<PValue> p_of(const HypothesisResult& result);

/// That test in words, with its numbers.
[[nodiscard]] std::string test_words(const HypothesisResult& result);

}  // namespace obscura::analysis
