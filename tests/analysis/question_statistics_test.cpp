// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Statistics of further questions: signed ranks, answers without a difference, confidence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analysis/conclusions/questions.h"
#include "analysis/presentation/questions_text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

TEST(SignedRank, GivesThePublishedValues) {
    // Darwin's maize as R's wilcox.test has it: V = 96, p-value = 0.04126.
    const auto maize = signed_rank({49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48});
    ASSERT_TRUE(maize.has_value());
    EXPECT_DOUBLE_EQ(maize->positive, 96.0);
    EXPECT_DOUBLE_EQ(maize->p.p, 2.0 * 676 / 32768);
    // Hollander and Wolfe 1973, 29f, the example of wilcox.test: V = 40, one-sided p = 0.01953.
    const auto depression =
        signed_rank({0.952, -0.147, 1.022, 0.43, 0.62, 0.59, 0.49, -0.08, 0.01});
    EXPECT_DOUBLE_EQ(depression->positive, 40.0);
    EXPECT_DOUBLE_EQ(depression->p.p, 2.0 * 10 / 512);
    EXPECT_TRUE(depression->is_exact);
}

TEST(SignedRank, IsExactWithEqualSizesAndLeavesZerosOut) {
    // By hand: sizes 1 1 1 2 3 have ranks 2 2 2 4 5; four of 32 signs reach a sum of at most 2.
    const auto small = signed_rank({1, 1, -1, 2, 3, 0, 0});
    EXPECT_EQ(small->n, 5);
    EXPECT_EQ(small->zeros, 2);
    EXPECT_DOUBLE_EQ(small->positive, 13.0);
    EXPECT_DOUBLE_EQ(small->p.p, 2.0 * 4 / 32);
    EXPECT_DOUBLE_EQ(signed_rank({2, 1, 1, 3, -1, 2, -2, 1, 4, 1})->p.p, 2.0 * 46 / 1024);
    EXPECT_DOUBLE_EQ(signed_rank({1, -1})->p.p, 1.0);
}

TEST(SignedRank, TakesTheNormalApproximationBeyondItsExactReach) {
    std::vector<double> differences;
    for (int i = 0; i < 300; ++i) {
        const int sign = i % 3 != 0 && i % 2 != 0 ? -1 : 1;
        differences.push_back(sign * (i + 1));
    }
    const auto test = signed_rank(differences);
    EXPECT_FALSE(test->is_exact);
    EXPECT_DOUBLE_EQ(test->positive, 30050.0);
    EXPECT_NEAR(test->p.p, 6.675453490744138e-07, 1e-18);
    // Both agree where they meet.
    differences.resize(kMostRanked);
    const double exact = signed_rank(differences)->p.p;
    differences.push_back(0.0);
    EXPECT_DOUBLE_EQ(signed_rank(differences)->p.p, exact);
}

TEST(SignedRank, HasNoValueWithoutADifferenceAndRefusesWhatIsNotFinite) {
    EXPECT_EQ(signed_rank({}).reason, "there are no differences");
    EXPECT_EQ(signed_rank({0.0, 0.0}).reason, "all differences are 0");
    EXPECT_THROW((void)signed_rank({std::nan("")}), base::Error);
    EXPECT_THROW((void)signed_rank({std::numeric_limits<double>::infinity()}), base::Error);
}

TEST(Davidson, OfOnePairReproducesItsCounts) {
    const TiedVotes votes{14, 22, 6};
    const auto fit = davidson_pair(votes);
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->log_odds, 0.4519851237430572, 1e-15);
    EXPECT_NEAR(fit->standard_error, 0.34188172937891387, 1e-15);
    EXPECT_NEAR(fit->nu, 0.3418817293789138, 1e-15);
    EXPECT_NEAR(fit->likelihood_ratio, 1.7927066084692846, 1e-12);
    EXPECT_NEAR(fit->p.p, 0.18059673717386476, 1e-12);
    EXPECT_NEAR(fit->interval.low, 0.44569239667177507, 1e-12);
    EXPECT_NEAR(fit->interval.high, 0.7543708106912648, 1e-12);
    // The model's probabilities are the shares that were met.
    const double a = 1.0 - fit->share_b;
    const double middle = fit->nu * std::sqrt(a * fit->share_b);
    EXPECT_NEAR(42.0 * fit->share_b / (1.0 + middle), 22.0, 1e-12);
    EXPECT_NEAR(42.0 * middle / (1.0 + middle), 6.0, 1e-12);
}

TEST(Davidson, SaysWhyThereIsNoValueAndRefusesCountsBelowZero) {
    EXPECT_EQ(davidson_pair({0, 0, 9}).reason, "nobody saw a difference");
    EXPECT_EQ(davidson_pair({0, 3, 9}).reason, "all who saw a difference chose the same image");
    EXPECT_THROW((void)davidson_pair({-1, 3, 0}), base::Error);
    EXPECT_THROW((void)split_share({1, 3, -2}), base::Error);
    EXPECT_THROW((void)split_share({1, 3, 2}, 1.0), base::Error);
}

TEST(Davidson, TiesThatAreSplitCountHalfForEachAndNotInTheSignTest) {
    const auto split = split_share({14, 22, 6});
    EXPECT_DOUBLE_EQ(split->share_b, 25.0 / 42.0);
    EXPECT_NEAR(split->p.p, 0.242985, 5e-7);  // binom.test(22, 36)
    EXPECT_NEAR(split->interval.low, 0.44494312750039344, 1e-9);
    EXPECT_NEAR(split->interval.high, 0.7295713885251867, 1e-9);
    EXPECT_EQ(split_share({0, 0, 4}).reason, "nobody saw a difference");
}

/// Answers of participants p1, p2 ... to one question of one pair.
void add(QuestionData& data, const std::string& question, const std::string& kind,
         const std::string& condition, const std::vector<std::string>& answers,
         const std::vector<bool>& chose_b, const std::string& about = kAboutPair) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
        QuestionAnswer answer;
        answer.condition = condition;
        answer.question = question;
        answer.question_kind = kind;
        answer.about = about;
        answer.answer = answers[i];
        data.answers.push_back({"p" + std::to_string(i + 1), answer, chose_b[i]});
    }
}

TEST(QuestionResults, ChoicesAreCountedAndTestedByTheRuleDeclaredBeforehand) {
    QuestionData data;
    data.asked = {{{"real", "choice", ""}, {"depth", "choice-or-none", ""}}, "split"};
    const std::vector<bool> any(9, true);
    add(data, "depth", "choice-or-none", "C2", {"A", "B", "B", "B", "B", "B", "B", "none", "none"},
        any);
    add(data, "depth", "choice-or-none", "C10", {"A", "A", "B", "B"}, any);
    const QuestionsResult split = analyse_questions(data);
    ASSERT_THAT(split.results, SizeIs(1));
    const QuestionCondition& first = split.results[0].conditions.at(0);
    EXPECT_EQ(first.condition, "C2");  // before C10
    EXPECT_EQ(first.votes.none, 2);
    EXPECT_DOUBLE_EQ(first.p->p, 0.125);  // 1 of 7: 2 (1 + 7) / 128
    EXPECT_DOUBLE_EQ(*first.p_holm, 0.25);
    EXPECT_EQ(split.tests, 2);
    data.asked.ties = "davidson";
    const QuestionsResult davidson = analyse_questions(data);
    EXPECT_DOUBLE_EQ(davidson.results[0].conditions.at(0).p->p, davidson_pair({1, 6, 2})->p.p);
    EXPECT_EQ(davidson.coins, 0) << "no tie of the first question";
}

TEST(QuestionResults, OneCorrectionIsOverTheTestsOfAllQuestions) {
    QuestionData data;
    data.asked = {{{"real", "choice", ""}, {"depth", "choice", ""}, {"sharp", "choice", ""}},
                  "split"};
    const std::vector<bool> any(8, true);
    add(data, "depth", "choice", "C1", std::vector<std::string>(8, "B"), any);
    add(data, "sharp", "choice", "C1", {"A", "B", "A", "B"}, any);
    const QuestionsResult results = analyse_questions(data);
    EXPECT_EQ(results.tests, 2);
    EXPECT_DOUBLE_EQ(results.results[0].conditions[0].p->p, 2.0 / 256);
    EXPECT_DOUBLE_EQ(*results.results[0].conditions[0].p_holm, 4.0 / 256);
    EXPECT_THAT(correction_words(results), HasSubstr("2 tests"));
}

TEST(QuestionResults, RatingsOfImagesAreComparedWithinParticipants) {
    QuestionData data;
    data.asked.list = {{"real", "choice", ""}, {"like", "rating", "", {}, true}};
    const std::vector<bool> any(5, true);
    add(data, "like", "rating", "C1", {"1", "2", "3", "4", "5"}, any, "A");
    add(data, "like", "rating", "C1", {"2", "3", "2", "6", "8"}, any, "B");
    const QuestionsResult results = analyse_questions(data);
    const QuestionCondition& of = results.results.at(0).conditions.at(0);
    EXPECT_DOUBLE_EQ(of.rating_a.mean, 3.0);
    EXPECT_DOUBLE_EQ(of.rating_b.mean, 4.2);
    EXPECT_DOUBLE_EQ(of.difference.mean, 1.2);
    EXPECT_DOUBLE_EQ(of.p->p, 0.25);  // differences 1 1 -1 2 3, above
    EXPECT_TRUE(of.rating_a.interval.has_value());
    // Student: 3 -+ 2.776445 sqrt(2.5 / 5)
    EXPECT_NEAR(of.rating_a.interval->low, 3.0 - 2.7764451052 * std::sqrt(0.5), 1e-8);
    EXPECT_EQ(results.tests, 1);
}

TEST(QuestionResults, ConfidenceIsHeldAgainstTheChoiceOfMostOthers) {
    QuestionData data;
    data.asked.list = {{"real", "choice", ""}, {"sure", "confidence", ""}};
    // Of C1 p1 to p3 chose B, p4 A; of C2 all but p1 chose A.
    add(data, "sure", "confidence", "C1", {"5", "4", "5", "1"}, {true, true, true, false});
    add(data, "sure", "confidence", "C2", {"2", "5", "4", "4"}, {true, false, false, false});
    const QuestionsResult results = analyse_questions(data);
    const ConfidenceResult& sure = results.results.at(0).confidence;
    ASSERT_THAT(sure.levels, SizeIs(4));
    EXPECT_EQ(sure.levels[0].step, 1);
    EXPECT_EQ(sure.levels[0].agreeing, 0);
    EXPECT_EQ(sure.levels[3].n, 3);
    EXPECT_EQ(sure.levels[3].agreeing, 3);
    // p1: 5 - 2, p4: 4 - 1; the others always agreed.
    EXPECT_EQ(sure.difference.n, 2);
    EXPECT_DOUBLE_EQ(sure.difference.mean, 3.0);
    EXPECT_DOUBLE_EQ(sure.signed_rank->p.p, 0.5);
    EXPECT_EQ(results.tests, 0);
    EXPECT_THAT(questions_text(results), HasSubstr("3.00 steps surer"));
}

TEST(QuestionResults, AnswersOfTheFirstQuestionWithoutADifferenceAreSaidToBeCoins) {
    QuestionData data;
    data.asked.list = {{"real", "choice-or-none", "Which?"}};
    add(data, "real", "choice-or-none", "C1", {"A", "none", "B"}, {false, true, true});
    const QuestionsResult results = analyse_questions(data);
    EXPECT_EQ(results.coins, 1);
    EXPECT_EQ(results.votes, 3);
    EXPECT_EQ(results.tests, 0) << "the pairs' own family has it";
    EXPECT_THAT(coin_words(results), HasSubstr("1 of 3 answers to the pairs saw no difference"));
    Json shown;
    put_questions(shown, results);
    EXPECT_EQ(shown["questions"]["questions"][0]["conditions"][0]["count_none"], 1);
}

}  // namespace
}  // namespace obscura::analysis
