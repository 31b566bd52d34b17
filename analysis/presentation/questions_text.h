// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/conclusions/questions.h"
#include "analysis/presentation/html.h"
#include "analysis/presentation/json_values.h"

namespace obscura::analysis {

// What a study's own questions came to, for text, page and JSON.

/// What was asked: `confidence (confidence): How sure are you?`
[[nodiscard]] std::string question_words(const AskedQuestion& question);
/// A row for each condition.
[[nodiscard]] PageTable question_table(const QuestionResult& result);
/// How confidence went with the choice of most others: a row for each step.
[[nodiscard]] PageTable confidence_table(const ConfidenceResult& confidence);
/// What the columns of such tables are, and what else there is to say.
[[nodiscard]] std::string question_note(const QuestionResult& result, const std::string& ties);
/// How the pairs' votes hold answers without a difference; empty: there are none.
[[nodiscard]] std::string coin_words(const QuestionsResult& questions);
/// What Holm's correction of the questions is over.
[[nodiscard]] std::string correction_words(const QuestionsResult& questions);

/// All of it as plain text; begins with an empty line.
[[nodiscard]] std::string questions_text(const QuestionsResult& questions);

/// Under the name `questions`.
void put_questions(Json& report, const QuestionsResult& questions);

}  // namespace obscura::analysis
