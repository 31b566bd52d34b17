// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/conclusions/words.h"

namespace obscura::analysis {

/// What a table shows where there is no value.
inline constexpr const char* kNoValue = "–";

/// A p-value in a table as journals print it, without its name; kNoValue where there is none.
[[nodiscard]] std::string p_cell(const Possible<PValue>& p);
[[nodiscard]] std::string p_cell(const Possible<double>& p);

/// A number in a table with so many decimals, or kNoValue.
[[nodiscard]] std::string cell(const Possible<double>& value, int decimals);

/// The conditions from low validity to high, otherwise as they are.
[[nodiscard]] std::vector<const ConditionResult*> by_validity(const Analysis& analysis);

/// `III: Crytek24 | Blizzard24 (moderate)`
[[nodiscard]] std::string label_of(const ConditionVotes& condition);

/// Whom a study's rule leaves out, after "who has".
[[nodiscard]] std::string rule_words(const ExclusionRule& rule);

}  // namespace obscura::analysis
