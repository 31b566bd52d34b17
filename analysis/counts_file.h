// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "analysis/tally.h"

namespace obscura::analysis {

/// Votes from a CSV file with the columns condition, hypothesis, validity, variant_a, variant_b,
/// count_a, count_b, in any order; one row a condition. Which variant is A
/// says is_a_of() in analysis/direction.h, whichever way round a row names them; conditions are in
/// natural order of their names. The number of participants is the number of
/// votes where every condition has the same. Throws bad input that lists everything wrong as
/// `file:line: column, value, what is allowed`.
[[nodiscard]] Tally read_counts(const std::filesystem::path& file);

/// The same for text; `name` stands for it in messages.
[[nodiscard]] Tally parse_counts(std::string_view text, const std::string& name);

}  // namespace obscura::analysis
