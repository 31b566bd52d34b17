// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stimuli/questions.h"
#include "stimuli/table_reader.h"

namespace obscura::stimuli {

/// The [[question]]s of a file, noting what is wrong. Adds their texts to what the study shows, and
/// makes the first one's text the study's question.
[[nodiscard]] Questions read_questions(const std::vector<const toml::table*>& entries, Study& study,
                                       std::vector<StudyProblem>& problems);

/// The key `ties` of [study], which takes effect only beside a choice-or-none.
void read_ties(const toml::table& study_table, Questions& questions,
               std::vector<StudyProblem>& problems);

}  // namespace obscura::stimuli
