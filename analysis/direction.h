// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "analysis/answers.h"

namespace obscura::analysis {

/// Where a variant stands in the order of techniques, by its name: 0 for none, then the accuracy
/// that Jakobsen 2010 (section 5.2) assumes, Crytek, Blizzard, ray marching, and last the
/// ray-traced reference. Nothing for any other technique: nobody ranked it.
[[nodiscard]] std::optional<int> assumed_rank(std::string_view variant);

/// The samples in a variant's name: 24 of Crytek24; 0 where it names none. Only of ranked variants.
[[nodiscard]] int samples_in_name(std::string_view variant);

/// **The direction of a comparison**, one rule for the whole analysis: which of two variants is A.
/// None comes first, then Crytek, Blizzard and ray marching as the thesis ranks them, then every
/// other technique, then the ray-traced reference; of one technique the one with fewer samples,
/// else the name that comes first in natural order (capital letters count for nothing unless the
/// names differ in nothing else). A strict order of all names.
[[nodiscard]] bool is_a_of(std::string_view one, std::string_view other);

/// Gives the answers of a table one direction, whatever way round each row names its pair. Where
/// all rows of a condition belong to a study and name the pair in the same way, that is the study's
/// definition and it holds; everywhere else is_a_of() decides. What is exchanged is A and B in the
/// condition, in the answer, in what was shown first and in what was expected.
void settle_direction(AnswerTable& table);

}  // namespace obscura::analysis
