// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/study.h"

namespace obscura::stimuli {

/// What a question of a pair is answered by: one of the two images; one of them, or that there is
/// no difference; a step of a scale; a step that says how sure the participant is of the choice.
enum class QuestionKind { kChoice, kChoiceOrNone, kRating, kConfidence };
inline constexpr std::array kQuestionKinds{QuestionKind::kChoice, QuestionKind::kChoiceOrNone,
                                           QuestionKind::kRating, QuestionKind::kConfidence};
/// `choice`, `choice-or-none`, `rating` or `confidence`, as in files.
[[nodiscard]] std::string_view to_string(QuestionKind kind);

/// What answers "no difference" count as: half a vote for each image, or by Davidson's model of
/// paired comparisons with ties (R. R. Davidson 1970).
enum class Ties { kSplit, kDavidson };
inline constexpr std::array kTies{Ties::kSplit, Ties::kDavidson};
/// `split` or `davidson`.
[[nodiscard]] std::string_view to_string(Ties ties);

/// Steps of a scale.
inline constexpr int kMostSteps = 11;

/// One question that is asked of each pair.
struct Question {
    std::string id;
    QuestionKind kind = QuestionKind::kChoice;
    std::string text;
    /// Of the answers, in order. A choice may have none, and has the kiosk's own words then; a
    /// scale has one for each step, or one for each end.
    std::vector<std::string> labels = {};
    /// Of each answer: names of kAdvanceKeys, one letter or one digit. Empty: the kiosk's own.
    std::vector<std::vector<std::string>> keys = {};
    int min = 1;  ///< of a scale
    int max = 7;
    bool each_image = false;  ///< a rating is given to the first and to the second image

    [[nodiscard]] bool is_scale() const {
        return kind == QuestionKind::kRating || kind == QuestionKind::kConfidence;
    }
    [[nodiscard]] int answer_count() const;
    /// The label of that answer, from 0; empty: the kiosk's own words, or a step between the ends.
    [[nodiscard]] std::string label_of(int answer) const;
};

/// What is asked of each pair, where a study says it by [[question]]: the first compares the two
/// images, and is what the pairs are analysed by. Stands in the study's file and is a value of its
/// own: no image, order or scene depends on it.
struct Questions {
    std::vector<Question> list;  ///< empty: Study::question alone, a choice
    Ties ties = Ties::kSplit;
};

/// The questions of the study in that file or of that name; none where it has none. The file is
/// one that load_study() takes.
[[nodiscard]] Questions load_questions(const std::string& file_or_name);

/// Study::plan_json() with what is asked and how answers without a difference count: `questions`
/// with id, kind, text, labels, min, max and of, and `ties`. The same where nothing is asked.
[[nodiscard]] std::string plan_json(const Study& study, const Questions& questions);

}  // namespace obscura::stimuli
