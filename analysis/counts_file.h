// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "analysis/table/columns.h"
#include "analysis/tally.h"

namespace obscura::analysis {

/// Votes from a table of any program (ForeignTable) with the columns variant_a, variant_b, count_a
/// and count_b, in any order, and where they are there condition, hypothesis, validity and scene;
/// one row a condition, which is called by its scene and variants where the file gives it no name.
/// Which variant is A says is_a_of() in analysis/direction.h, whichever way round a row names them;
/// conditions are in natural order of their names.
/// `map` says what the file calls the columns; others are passed over and named in Tally::notes.
/// Counts are whole numbers in any spelling: 12, 12.0, 1e+05. The number of participants is the
/// number of votes where every condition has the same. Throws bad input that lists everything wrong
/// as `file:line: column, value, what is allowed`, each problem once.
[[nodiscard]] Tally read_counts(const std::filesystem::path& file, const ColumnMap& map = {});

/// The same for the bytes of a file; `name` stands for it in messages.
[[nodiscard]] Tally parse_counts(std::string bytes, const std::string& name,
                                 const ColumnMap& map = {});

}  // namespace obscura::analysis
