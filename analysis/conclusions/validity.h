// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// Whether the preference depends on validity, where that is asked: by an interaction of the family
/// (then of just its pairs), by answers to the built-in study, or by Tally::asks_validity, which is
/// secondary where the study fixed its family without it. Otherwise no value, with the reason.
/// Intervals are from the same participants or from counts.
[[nodiscard]] Possible<ValidityResult> test_validity(const Tally& tally, const Family& family);

}  // namespace obscura::analysis
