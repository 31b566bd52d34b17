// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/questions_text.h"
#include "analysis/presentation/report_parts.h"

namespace obscura::analysis {

void add_questions(ReportDraft& draft) {
    if (!draft.input.questions) return;
    const QuestionsResult& questions = *draft.input.questions;
    draft.page.heading("What else was asked of each pair");
    if (const std::string coins = coin_words(questions); !coins.empty()) {
        draft.page.notice(coins);
    }
    draft.page.paragraph(correction_words(questions));
    for (const QuestionResult& result : questions.results) {
        draft.page.heading(question_words(result.question), 3);
        draft.page.table(question_table(result), question_note(result, questions.ties));
        if (result.confidence.levels.empty()) continue;
        draft.page.table(confidence_table(result.confidence),
                         "Of choices given with that confidence, those that most of the other "
                         "participants shared; pairs that divide the others evenly are left out.");
    }
}

}  // namespace obscura::analysis
