// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/chi_square.h"

namespace obscura::analysis {

/// Whether the share of yes is the same under all conditions when the same participants answered
/// each of them (W. G. Cochran 1950). `rows`: one for each participant, with one answer for each
/// condition. df = conditions - 1. Participants whose answers are all alike say nothing and change
/// nothing; no value when all are such, for fewer than two conditions and without participants.
/// Throws bad input when the rows differ in length.
[[nodiscard]] Possible<ChiSquareTest> cochran_q(const std::vector<std::vector<bool>>& rows);

}  // namespace obscura::analysis
