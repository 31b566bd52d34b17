// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stimuli/study.h"
#include "stimuli/table_reader.h"

namespace obscura::stimuli {

// What a study file says of attention: the keys `catch` and `repeats` of a condition and the table
// [exclusion]. Each function notes what is wrong, at its line.

/// `catch = "a"` or `"b"` as 'A' or 'B'; 0 where it is missing or wrong.
[[nodiscard]] char read_expected(TableReader& reader);

/// Whether the images are meant to be alike; refuses what then has no meaning: a side to be picked
/// and a hypothesis to vote on.
[[nodiscard]] bool read_identical(TableReader& reader, const Condition& condition);
/// Notes what a pair of practice cannot be besides.
void check_practice(TableReader& reader, const Condition& condition);

/// `repeats`, the whole rest of its condition: whatever else but the id is refused. Which condition
/// it is shows once all are read.
void read_repeats(TableReader& reader, Condition& condition);

/// Gives every condition that repeats another one the scene, hypothesis and sides of that. `tables`
/// are those that the study's conditions were read from, in the same order.
void resolve_repeats(Study& study, const std::vector<const toml::table*>& tables,
                     std::vector<StudyProblem>& problems);

/// The rule of exclusion; refuses one that asks for what the study's conditions cannot tell.
void read_exclusion(const toml::table& table, const std::vector<const toml::table*>& conditions,
                    Study& study, std::vector<StudyProblem>& problems);

}  // namespace obscura::stimuli
