// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/report/analysis.h"

namespace obscura::analysis {

/// The name of the hypothesis that the effect depends on validity.
inline constexpr std::string_view kValidityHypothesis = "H3";

/// A verdict on every hypothesis that conditions name, and on kValidityHypothesis, by
/// verdict_rule(). Needs hypotheses, validity, resampling and power of the analysis.
[[nodiscard]] std::vector<Verdict> verdicts_of(const Analysis& analysis);

/// The interval that the verdict on pooled votes rests on: over participants where there is one,
/// Wilson's where only counts are known, or too many participants to draw from.
[[nodiscard]] Possible<Bounds> verdict_interval(const HypothesisResult& result, const Tally& tally);

/// Conclusions that differ between the analysis and that of everybody, each in a sentence.
[[nodiscard]] std::vector<std::string> changed_conclusions(const Analysis& analysis,
                                                           const Analysis& everybody);

}  // namespace obscura::analysis
