// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/tally.h"

namespace obscura::analysis {

/// The answers of a file, as the store would hold them. Fields that the file does not have keep
/// their defaults; a session that says nothing of its state was completed.
struct TrialsFile {
    std::string name;
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;
    std::string order_unknown;  ///< why first_shown has no meaning; empty where it has
};

/// Forced-choice answers from a CSV file, one row a trial, columns in any order:
/// - observer (or participant_id), condition_A, condition_B: what was compared;
///   is_A_selected: 0, 1, true or false. These are needed.
/// - session_id, scene, and order: AB or BA (A or B) for what was shown first, or the number of the
///   trial in its session.
/// - every column of the exported trials.csv; condition, hypothesis, validity, first_shown,
///   response, trial_index, kind, study, session_state, expected, repeats and exclusion are read,
///   the others passed over.
/// Without the column condition, a condition is a scene with two variants, whichever of them is
/// called A; A is then what the first row calls so. Throws bad input that lists what is wrong as
/// `file:line: column, value, what is allowed`, the first 100 in full.
[[nodiscard]] TrialsFile read_trials(const std::filesystem::path& file);

/// The same for text; `name` stands for it in messages.
[[nodiscard]] TrialsFile parse_trials(std::string_view text, const std::string& name);

/// Its votes, as tally_trials gives them for a store.
[[nodiscard]] Tally tally_of(const TrialsFile& file, const std::string& study, Kind kind);

}  // namespace obscura::analysis
