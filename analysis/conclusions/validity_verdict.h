// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/corrected_tests.h"

namespace obscura::analysis {

/// The verdict on validity, from its comparisons' tests at `places` of the corrected family (unused
/// where the question is secondary).
[[nodiscard]] Verdict verdict_on_validity(const ValidityResult& validity,
                                          const CorrectedTests& family,
                                          const std::vector<std::size_t>& places);

}  // namespace obscura::analysis
