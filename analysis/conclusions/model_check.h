// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// Fits the mixed model of every hypothesis with pooled votes and of every comparison between
/// levels: HypothesisResult::model and Comparison::model. Needs to know each answer.
void check_by_model(Analysis& analysis);

/// What the model says of the verdict's test, in one sentence; why there is none.
[[nodiscard]] std::string model_words(const Possible<ModelCheck>& model,
                                      const Possible<PValue>& tested);

/// What no model here says: that scenes other than these would give the same.
inline constexpr const char* kScenesAreFixed =
    "Conditions and scenes are fixed in these models, as in every test here: nothing of this "
    "generalises to other scenes, for which many scenes would have to be drawn (H. H. Clark 1973).";

/// Answers up to which `obscura analyze` fits the model unasked.
inline constexpr std::int64_t kMostModelled = 100'000;

}  // namespace obscura::analysis
