// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/questions/answers.h"
#include "analysis/statistics/davidson.h"
#include "analysis/statistics/mean_test.h"
#include "analysis/statistics/signed_rank.h"

namespace obscura::analysis {

class Store;

/// An answer to a question of a pair that people vote on, and who gave it.
struct PairAnswer {
    std::string participant;
    QuestionAnswer answer;
    bool chose_b = false;  ///< how the pair was voted on
};

/// What completed sessions answered to the questions of their study.
struct QuestionData {
    AskedQuestions asked;  ///< empty: the pairs alone
    std::vector<PairAnswer> answers;
};

/// Why there are none where a study asks of its pairs only which one is chosen.
inline constexpr const char* kNothingElseAsked = "no session asked more than the pairs";

/// Of the completed sessions of that study and kind. Practice, attention checks and repeats are
/// left out as they are from the votes. Nothing where not all sessions asked the same, with the
/// reason.
[[nodiscard]] Possible<QuestionData> read_question_data(Store& store, const std::string& study,
                                                        Kind kind);

/// A mean over participants, with Student's interval where they differ.
struct MeanRating {
    std::int64_t n = 0;
    double mean = 0.0;
    Possible<Interval> interval = Possible<Interval>::none("no answers");
};

/// One condition of a question. What its kind does not ask is not there.
struct QuestionCondition {
    std::string condition;
    TiedVotes votes;  ///< of a choice, with or without a difference
    Possible<SplitShare> split = Possible<SplitShare>::none("not a choice");
    Possible<DavidsonPair> davidson = Possible<DavidsonPair>::none("not a choice");
    MeanRating rating;    ///< of the pair
    MeanRating rating_a;  ///< of each image
    MeanRating rating_b;
    MeanRating difference;  ///< B less A of each participant
    Possible<SignedRankTest> signed_rank = Possible<SignedRankTest>::none("not of each image");
    /// The p-value of the question: by the rule for answers without a difference, or of ratings of
    /// each image; and after Holm's correction over those of all questions.
    Possible<PValue> p = Possible<PValue>::none("a rating of the pair has no test");
    Possible<double> p_holm = Possible<double>::none("no test");
};

/// How sure those were whose choice is that of most of the others.
struct ConfidenceLevel {
    int step = 0;
    std::int64_t n = 0;
    std::int64_t agreeing = 0;
};
struct ConfidenceResult {
    std::vector<ConfidenceLevel> levels;  ///< rising
    /// Of each participant with both: mean confidence where the choice was that of most others,
    /// less where it was not.
    MeanRating difference;
    Possible<SignedRankTest> signed_rank = Possible<SignedRankTest>::none("no answers");
};

struct QuestionResult {
    AskedQuestion question;
    bool is_first = false;  ///< by which the pairs are compared: its votes are the main analysis'
    std::vector<QuestionCondition> conditions;  ///< in natural order
    ConfidenceResult confidence;                ///< of a question of confidence
};

struct QuestionsResult {
    std::string ties;                     ///< rule for answers without a difference
    std::vector<QuestionResult> results;  ///< a plain choice that comes first has none
    std::int64_t tests = 0;               ///< that Holm's correction is over
    /// Of the pairs' votes, those that a coin gave to a side: nobody saw a difference.
    std::int64_t coins = 0;
    std::int64_t votes = 0;
};

[[nodiscard]] QuestionsResult analyse_questions(const QuestionData& data);

}  // namespace obscura::analysis
