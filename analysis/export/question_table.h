// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/export/source.h"
#include "analysis/questions/answers.h"

namespace obscura::analysis {

/// An answer to a question of a pair with the session it belongs to.
struct QuestionRow {
    const QuestionAnswer* answer = nullptr;
    const SessionRecord* session = nullptr;
};

/// Columns of the table `answers`; the questions that `source` has are levels of a column.
[[nodiscard]] ExportTable<QuestionRow> answers_export(ExportSource& source);

/// The columns of trials.csv, with one more where a pair may have been answered by "no difference":
/// that is then no vote of the participant's, and the row has what a coin gave.
[[nodiscard]] ExportTable<TrialRow> trials_with_ties(ExportSource& source);

}  // namespace obscura::analysis
