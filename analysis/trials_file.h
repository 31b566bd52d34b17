// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "analysis/answers.h"
#include "analysis/table/columns.h"

namespace obscura::analysis {

/// Forced-choice answers from a table of any program (ForeignTable), one row a trial, columns in
/// any order. Needed are:
/// - observer (or participant_id), condition_A, condition_B: who compared what;
/// - is_A_selected or chose_B: yes or no in any spelling (truth()); or chosen (ChoiceReader): the
///   chosen variant.
/// Where they are there, these are read too:
/// - session_id, scene, and order: AB or BA (A or B) for what was shown first, or the number of the
///   trial in its session; response_time in s or response_time_ms, empty where unknown;
/// - every column of the exported trials.csv: condition, hypothesis, validity, first_shown,
///   response, trial_index, kind, study, study_A, session_state, expected, repeats, exclusion and
///   study_plan.
/// `map` says what the file calls them. All others are passed over and named in AnswerTable::notes.
/// Rows without both variants (an instruction, a break) and rows without an answer are passed over
/// and counted there; rows that are equal and repeated votes are named there.
/// Without the column condition, a condition is a scene with two variants (and a level of validity,
/// where they are shown at several), whichever of them is called A. Which is A in the table says
/// settle_direction() in analysis/direction.h, never the order of rows. A session that says nothing
/// of its state was completed. Throws bad input that lists what is wrong as `file:line: column,
/// value, what is allowed`, each problem once.
[[nodiscard]] AnswerTable read_trials(const std::filesystem::path& file, const ColumnMap& map = {});

/// The same for the bytes of a file; `name` stands for it in messages.
[[nodiscard]] AnswerTable parse_trials(std::string bytes, const std::string& name,
                                       const ColumnMap& map = {});

}  // namespace obscura::analysis
