// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// Whether the preference depends on validity, where that is asked: by the built-in study, its
/// published votes, or Tally::asks_validity. Otherwise no value, with the reason. Intervals are
/// from the same participants or from counts.
[[nodiscard]] Possible<ValidityResult> test_validity(const Tally& tally);

}  // namespace obscura::analysis
