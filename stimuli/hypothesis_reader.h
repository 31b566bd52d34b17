// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "stimuli/study.h"
#include "stimuli/table_reader.h"

namespace obscura::stimuli {

/// Reads a [[hypothesis]] but its id, against the conditions that the study has by then, and notes
/// what is wrong at its line.
[[nodiscard]] Hypothesis read_hypothesis(TableReader& reader, const std::string& id,
                                         const Study& study);

/// What the hypotheses of a study and the key `hypothesis` of its conditions must be for each
/// other: where there are hypotheses the key is only a label and must name one of them; a condition
/// without the key is labelled with the first preference that takes it. `conditions` and
/// `hypotheses` are the tables that they were read from.
void settle_hypotheses(Study& study, const std::vector<const toml::table*>& conditions,
                       const std::vector<const toml::table*>& hypotheses,
                       std::vector<StudyProblem>& problems);

/// The table [stopping].
void read_stopping(const toml::table& table, Study& study, std::vector<StudyProblem>& problems);

}  // namespace obscura::stimuli
