// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "analysis/answers.h"

namespace obscura::analysis {

/// Forced-choice answers from a CSV file, one row a trial, columns in any order:
/// - observer (or participant_id), condition_A, condition_B: what was compared;
///   is_A_selected: 0, 1, true or false. These are needed.
/// - session_id, scene, and order: AB or BA (A or B) for what was shown first, or the number of the
///   trial in its session; response_time (or `response_time (s)`) in s, empty or n/a where unknown.
/// - every column of the exported trials.csv; condition, hypothesis, validity, first_shown,
///   response, trial_index, kind, study, session_state, expected, repeats and exclusion are read,
///   the others passed over.
/// Without the column condition, a condition is a scene with two variants (and a level of validity,
/// where they are shown at several), whichever of them is called A. Which is A in the table says
/// settle_direction() in analysis/direction.h, never the order of rows. A session that says nothing
/// of its state was completed. The file is read in pieces. Throws bad input that lists what is
/// wrong as `file:line: column, value, what is allowed`, the first 100 in full.
[[nodiscard]] AnswerTable read_trials(const std::filesystem::path& file);

/// The same for text; `name` stands for it in messages.
[[nodiscard]] AnswerTable parse_trials(std::string_view text, const std::string& name);

}  // namespace obscura::analysis
