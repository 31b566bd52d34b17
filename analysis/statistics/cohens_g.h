// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Cohen's g, the effect size of a share (J. Cohen 1988, chapter 5): share of B minus one half,
/// -0.5 to 0.5; .05 is called small, .15 medium, .25 large. No value without votes. Throws bad
/// input for counts outside 0 to kMaxCount.
[[nodiscard]] Possible<double> cohens_g(const Votes& votes);

}  // namespace obscura::analysis
