// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/store/records.h"

namespace obscura::analysis {

/// The name of an event that is an answer to a question of a pair. Answers of a study's own
/// questions lie among the events of their session, in any store that there ever was, and are
/// merged, spooled and withdrawn with them. What the pairs are compared by is a trial; only where
/// that question may also be answered by "no difference" its answers are here too.
inline constexpr const char* kAnswerEvent = "answer";

/// What a question is about: a pair, or one image of it (its side A or B).
inline constexpr const char* kAboutPair = "pair";
/// The answer that there is no difference.
inline constexpr const char* kNoDifference = "none";

/// One answer to a question of a pair.
struct QuestionAnswer {
    std::string session_id = {};
    int trial_index = 0;  ///< of the pair in its session, as of its trial
    std::string condition = {};
    std::string question = {};       ///< its id
    std::string question_kind = {};  ///< choice, choice-or-none, rating or confidence
    std::string about = kAboutPair;  ///< pair, A or B
    std::string answer = {};         ///< A, B, none, or a step of the scale
    std::string label = {};          ///< what the participant pressed, in the study's language
    double response_time_s = 0.0;    ///< from the question's onset
    std::string answered_utc = {};

    bool operator==(const QuestionAnswer&) const = default;
};

/// As the event that is stored.
[[nodiscard]] EventRecord to_event(const QuestionAnswer& answer);

/// The answers among the events, in order. Of two of one session to the same question of the same
/// pair and image the later one counts: the first was cut off before its pair was answered. Throws
/// failure for an event of that name that is no answer.
[[nodiscard]] std::vector<QuestionAnswer> answers_among(const std::vector<EventRecord>& events);

/// A question as a session carries it in SessionRecord::study_plan.
struct AskedQuestion {
    std::string id;
    std::string kind;
    std::string text = {};
    std::vector<std::string> labels = {};
    bool each_image = false;
};

/// What a session asked of each pair, and how answers without a difference were to count.
struct AskedQuestions {
    std::vector<AskedQuestion> list;  ///< empty: the choice alone
    std::string ties = "split";       ///< or davidson

    /// Whether a trial may be one that saw no difference.
    [[nodiscard]] bool first_has_ties() const {
        return !list.empty() && list.front().kind == "choice-or-none";
    }
};

/// Of a text that study_plan() takes.
[[nodiscard]] AskedQuestions asked_questions(std::string_view study_plan);

}  // namespace obscura::analysis
