// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/tally.h"

namespace obscura::analysis {

/// One row of Table 4 of Jakobsen 2010 as the thesis prints it.
struct PrintedTest {
    std::string condition;
    std::string chi_square;
    std::string p;
    bool is_bold = false;  ///< called significant there
};

/// Whether these are the votes of Jakobsen 2010, condition by condition.
[[nodiscard]] bool is_published_votes(const Tally& tally);

/// Says of each condition of published votes which scene it showed, which the counts do not.
void add_published_views(Tally& tally);

/// Table 4, in its order.
[[nodiscard]] const std::vector<PrintedTest>& printed_table_4();

/// The hypotheses of the built-in study as its file fixes them, which the published votes do not
/// carry.
[[nodiscard]] const std::vector<PlannedHypothesis>& published_hypotheses();

/// Whether these are the published votes or answers to the built-in study.
[[nodiscard]] bool is_built_in(const Tally& tally);

/// Who took part, from section 5.4 of the thesis, in this program's words.
[[nodiscard]] std::string published_participants();

/// The name of the study whose hypotheses those are.
inline constexpr const char* kPublishedStudy = "jakobsen2010";

}  // namespace obscura::analysis
