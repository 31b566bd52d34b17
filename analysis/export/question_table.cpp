// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/question_table.h"

#include <algorithm>

#include "analysis/export/member_cells.h"
#include "analysis/export/table_words.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

template <auto kMember>
ExportCell<QuestionRow> of_answer() {
    return {
        [](const QuestionRow& row, std::string& out) { append_cell(out, row.answer->*kMember); },
        false};
}

template <auto kMember>
ExportCell<QuestionRow> of_its_session() {
    return {
        [](const QuestionRow& row, std::string& out) { append_cell(out, row.session->*kMember); },
        false};
}

/// English name and the participants' words of every question.
Levels question_levels(ExportSource& source) {
    Levels levels;
    source.each_asked([&](const AskedQuestions& asked) {
        for (const AskedQuestion& question : asked.list) {
            const auto known = std::find_if(levels.begin(), levels.end(), [&](const auto& level) {
                return level.first == question.id;
            });
            if (known == levels.end()) levels.emplace_back(question.id, question.text);
        }
    });
    return levels;
}

}  // namespace

ExportTable<QuestionRow> answers_export(ExportSource& source) {
    using S = SessionRecord;
    using A = QuestionAnswer;
    return {
        "answers",
        {
            {"participant_id",
             "Participant, as in the table participants",
             {},
             "",
             of_its_session<&S::participant_id>()},
            {"session_id",
             "Session, as in the table sessions",
             {},
             "",
             of_its_session<&S::session_id>()},
            {"kind", "Who answered", kSubjectKinds, "", of_its_session<&S::kind>()},
            {"study", "Name of the study", {}, "", of_its_session<&S::study>()},
            {"trial_index",
             "Place of the pair in its session from 0, as in the table trials",
             {},
             "",
             {[](const QuestionRow& row, std::string& out) {
                  append_cell(out, row.answer->trial_index);
              },
              true}},
            {"condition", "Name of the condition", {}, "", of_answer<&A::condition>()},
            {"question", "What was asked; the levels have the words that participants read",
             question_levels(source), "", of_answer<&A::question>()},
            {"question_kind",
             "How it is answered",
             {{"choice", "one of the two images"},
              {"choice-or-none", "one of them, or that there is no difference"},
              {"rating", "a step of a scale"},
              {"confidence", "a step of a scale: how sure the choice is"}},
             "",
             of_answer<&A::question_kind>()},
            {"about",
             "What the answer is about",
             {{"pair", "the pair"}, {"A", "its image A"}, {"B", "its image B"}},
             "",
             of_answer<&A::about>()},
            {"answer",
             "A or B: the image that was chosen; none: no difference; of a scale the number of the "
             "step",
             {},
             "",
             of_answer<&A::answer>()},
            {"label",
             "What stood on the button that was pressed, in the study's language",
             {},
             "",
             of_answer<&A::label>()},
            {"response_time_s",
             "From the question's onset to the answer, without time in which it was hidden",
             {},
             "s",
             {[](const QuestionRow& row, std::string& out) {
                  append_cell(out, row.answer->response_time_s);
              },
              true}},
            {"answered_utc",
             std::string(kUtc) + ", when it was answered",
             {},
             "",
             of_answer<&A::answered_utc>(),
             true},
        }};
}

ExportTable<TrialRow> trials_with_ties(ExportSource& source) {
    ExportTable<TrialRow> table = trials_export();
    bool any = false;
    source.each_asked([&](const AskedQuestions& asked) { any = any || asked.first_has_ties(); });
    if (!any) return table;
    table.columns.push_back(
        {"no_difference",
         "The participant saw no difference. What the row says was selected is then what a coin "
         "gave, fixed by session and pair, or in an attention check the image that was not "
         "expected; empty: that answer was not offered",
         kYesNo,
         "",
         {[](const TrialRow& row, std::string& out) {
              if (row.no_difference) append_cell(out, *row.no_difference);
          },
          true}});
    return table;
}

}  // namespace obscura::analysis
