// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/mixed_logistic.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/conclusions/analysis.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/text_report.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "tests/analysis/edge_inputs.h"

namespace obscura::analysis {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

/// Contagious bovine pleuropneumonia: herd, new cases, animals, period (lme4's data `cbpp`, of M.
/// Lesnoff et al. 2004, Preventive Veterinary Medicine 64, 121).
struct Cbpp {
    int herd, incidence, size, period;
};
constexpr std::array<Cbpp, 56> kCbpp{
    {{1, 2, 14, 1},  {1, 3, 12, 2},  {1, 4, 9, 3},   {1, 0, 5, 4},    {2, 3, 22, 1},
     {2, 1, 18, 2},  {2, 1, 21, 3},  {3, 8, 22, 1},  {3, 2, 16, 2},   {3, 0, 16, 3},
     {3, 2, 20, 4},  {4, 2, 10, 1},  {4, 0, 10, 2},  {4, 2, 9, 3},    {4, 0, 6, 4},
     {5, 5, 18, 1},  {5, 0, 25, 2},  {5, 0, 24, 3},  {5, 1, 4, 4},    {6, 3, 17, 1},
     {6, 0, 17, 2},  {6, 0, 18, 3},  {6, 1, 20, 4},  {7, 8, 16, 1},   {7, 1, 10, 2},
     {7, 3, 9, 3},   {7, 0, 5, 4},   {8, 12, 34, 1}, {9, 2, 9, 1},    {9, 0, 6, 2},
     {9, 0, 8, 3},   {9, 0, 6, 4},   {10, 1, 22, 1}, {10, 1, 22, 2},  {10, 0, 18, 3},
     {10, 2, 22, 4}, {11, 0, 25, 1}, {11, 5, 27, 2}, {11, 3, 22, 3},  {11, 1, 22, 4},
     {12, 2, 10, 1}, {12, 1, 8, 2},  {12, 0, 6, 3},  {12, 0, 5, 4},   {13, 1, 21, 1},
     {13, 2, 24, 2}, {13, 0, 19, 3}, {13, 0, 23, 4}, {14, 11, 19, 1}, {14, 0, 2, 2},
     {14, 0, 3, 3},  {14, 0, 2, 4},  {15, 1, 19, 1}, {15, 1, 15, 2},  {15, 1, 15, 3},
     {15, 0, 15, 4}}};

std::vector<MixedParticipants> cbpp() {
    std::vector<MixedParticipants> herds(15);
    for (const Cbpp& row : kCbpp) {
        MixedAnswers answers{{{0, 1.0}}, {row.size - row.incidence, row.incidence}};
        if (row.period > 1) answers.x.emplace_back(static_cast<std::size_t>(row.period - 1), 1.0);
        herds[static_cast<std::size_t>(row.herd - 1)].answers.push_back(answers);
    }
    return herds;
}

TEST(MixedLogistic, MeetsLme4OnCbppWithManyNodes) {
    // lme4 1.1-31, glmer(..., nAGQ = 25), bobyqa to 1e-12; its log likelihood leaves out that of
    // the saturated model, -41.97835377.
    const auto fit = mixed_logistic(cbpp(), 4);
    ASSERT_TRUE(fit.has_value()) << fit.reason;
    constexpr std::array<double, 4> kValues{-1.399230449, -.991403677, -1.127819465, -1.579470786};
    constexpr std::array<double, 4> kErrors{.2335115, .3067679, .3267683, .4275944};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(fit->coefficients[i], kValues[i], 1e-7);
        EXPECT_NEAR(std::sqrt(fit->covariance[i * 5]), kErrors[i], 5e-7);
    }
    EXPECT_NEAR(fit->sd, .647518476, 1e-7);
    EXPECT_NEAR(fit->log_likelihood, -50.00501527 - 41.97835377, 1e-7);
    EXPECT_NEAR(mixed_log_likelihood(cbpp(), fit->coefficients, fit->sd, 25), fit->log_likelihood,
                1e-7);
}

TEST(MixedLogistic, MeetsLme4OnCbppByLaplace) {
    // What is usually printed, glmer's default of one node, stops short of the largest likelihood;
    // run on to 1e-12 it ends at the second point.
    const std::vector<double> printed{-1.398343, -.991925, -1.128216, -1.579745};
    const std::vector<double> largest{-1.398532148, -.992332654, -1.128672011, -1.580313926};
    const double at_printed = mixed_log_likelihood(cbpp(), printed, .642070, 1);
    const double at_largest = mixed_log_likelihood(cbpp(), largest, .64226144, 1);
    EXPECT_NEAR(at_printed, -92.02657, 3e-4);
    EXPECT_NEAR(at_largest, -92.02628187, 1e-8);
    EXPECT_GT(at_largest, at_printed);
    for (std::size_t i = 0; i < 4; ++i) {
        for (const double step : {-1e-3, 1e-3}) {
            std::vector<double> beside = largest;
            beside[i] += step;
            EXPECT_LT(mixed_log_likelihood(cbpp(), beside, .64226144, 1), at_largest);
        }
    }
    EXPECT_LT(mixed_log_likelihood(cbpp(), largest, .6412, 1), at_largest);
    EXPECT_LT(mixed_log_likelihood(cbpp(), largest, .6432, 1), at_largest);
    const auto fit = mixed_logistic(cbpp(), 4);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(fit->coefficients[i], printed[i], 1e-3);
    EXPECT_NEAR(fit->sd, .642070, 6e-3) << "Laplace's is a little smaller";
}

TEST(MixedLogistic, OfPeopleWhoDoNotDifferIsTheLogisticRegression) {
    // Numbers of four coins of .75 in less than their spread: the deviation is 0.
    std::vector<MixedParticipants> data;
    for (int i = 0; i < 40; ++i) data.push_back({{{{{0, 1.0}}, {1, 3}}}, 1});
    const auto fit = mixed_logistic(data, 1);
    ASSERT_TRUE(fit.has_value()) << fit.reason;
    EXPECT_NEAR(fit->coefficients[0], std::log(3.0), 1e-6);
    EXPECT_EQ(fit->sd, 0.0);
    EXPECT_NEAR(std::sqrt(fit->covariance[0]), 1.0 / std::sqrt(160.0 * 3.0 / 16.0), 1e-6);
}

TEST(NestedTest, IsTheClosedFormOfTwoTermsAndChiSquareInTheLimit) {
    for (const double statistic : {0.0, .5, 6.0, 40.0}) {
        // Of df 2 the tail of F is (1 + statistic / error_df)^(-error_df / 2).
        const NestedTest test = nested_test(statistic, 2, 84, 12);
        EXPECT_EQ(test.error_df, 70);
        EXPECT_NEAR(test.p.p, std::pow(1.0 + statistic / 70.0, -35.0), 1e-12);
        EXPECT_GE(test.p.p, chi_square_tail(statistic, 2).p);
        EXPECT_NEAR(nested_test(statistic, 5, 1'000'000'005, 0).p.p,
                    chi_square_tail(statistic, 5).p, 1e-6);
    }
}

TEST(NestedTest, RefusesWhatLeavesNothingWithinParticipants) {
    EXPECT_THROW((void)nested_test(1.0, 5, 17, 12), base::Error);
    EXPECT_THROW((void)nested_test(-1.0, 5, 72, 12), base::Error);
    EXPECT_THROW((void)nested_test(std::nan(""), 5, 72, 12), base::Error);
    EXPECT_THROW((void)nested_test(1.0, 0, 72, 12), base::Error);
}

TEST(MixedLogistic, SaysSeparationAndTermsThatCannotBeToldApart) {
    EXPECT_EQ(mixed_logistic({}, 1).reason, "no answers");
    const std::vector<MixedParticipants> all_b(12, {{{{{0, 1.0}}, {0, 3}}}, 1});
    EXPECT_THAT(mixed_logistic(all_b, 1).reason, HasSubstr("separated"));
    std::vector<MixedParticipants> twice;
    for (int i = 0; i < 12; ++i) {
        twice.push_back({{{{{0, 1.0}, {1, 1.0}}, {i % 3, 3 - i % 3}}}, 1});
    }
    EXPECT_FALSE(mixed_logistic(twice, 2).has_value());
    std::vector<MixedParticipants> once;
    for (int i = 0; i < 12; ++i) once.push_back({{{{{0, 1.0}}, {i % 2, 1 - i % 2}}}, 1});
    once.push_back({{{{{0, 1.0}}, {0, 1}}}, 1});
    EXPECT_THAT(mixed_logistic(once, 1).reason, HasSubstr("cannot be told apart"))
        << "one vote each says nothing of how people differ";
    EXPECT_THROW((void)mixed_logistic({{{{{{0, std::nan("")}}, {1, 1}}}, 1}}, 1), base::Error);
    EXPECT_THROW((void)mixed_logistic({{{{{{1, 1.0}}, {1, 1}}}, 1}}, 1), base::Error);
    for (const Votes& votes : tests::kImpossibleVotes) {
        EXPECT_THROW((void)mixed_logistic({{{{{{0, 1.0}}, votes}}, 1}}, 1), base::Error);
    }
}

/// People with a liking for B of their own (log odds, mean `liking`), who answer three conditions
/// at either level; the second image draws by `pull`.
std::string answers_of(int people, double liking, double spread, double pull, std::uint64_t seed) {
    base::Random random(seed);
    std::string text =
        "observer,study,condition,scene,validity,hypothesis,condition_A,condition_B,is_A_selected,"
        "first_shown\n";
    for (int who = 0; who < people; ++who) {
        double own = -6.0;  // the sum of twelve has variance 1
        for (int i = 0; i < 12; ++i) own += random.uniform(0.0, 1.0);
        for (int i = 0; i < 6; ++i) {
            const bool b_second = (who + i) % 2 == 0;
            const double odds = std::exp(liking + spread * own + (b_second ? pull : -pull));
            const bool chose_b = random.uniform(0.0, 1.0) < odds / (1.0 + odds);
            text += fmt::format("p{},jakobsen2010,c{},s{},{},H1,None,Blizzard24,{:d},{}\n", who, i,
                                i / 2, i % 2 == 0 ? "moderate" : "high", !chose_b,
                                b_second ? 'A' : 'B');
        }
    }
    return text;
}

TEST(ModelCheck, FindsWhatTheAnswersWereMadeWith) {
    const Analysis analysis = analyse(
        tally_of(parse_trials(answers_of(600, .4, 1.0, .3, 3), "t.csv"), "", Kind::kParticipant),
        {.model = true});
    const ModelCheck& model = *analysis.hypotheses.at(0).model;
    EXPECT_EQ(model.participants, 600);
    EXPECT_NEAR(model.effect->log_odds, .4, 3.0 * model.effect->standard_error);
    EXPECT_NEAR(model.effect->standard_error, .055, .01);
    EXPECT_NEAR(model.sd, 1.0, .2);
    EXPECT_NEAR(model.order->log_odds, .3, 3.0 * model.order->standard_error);
    EXPECT_EQ(model.conditions_differ->df, 5);
    const ModelCheck& levels = *analysis.validity->by_level.at(0).model;
    EXPECT_NEAR(levels.effect->log_odds, 0.0, 3.0 * levels.effect->standard_error);
    EXPECT_THAT(text_report(analysis),
                AllOf(HasSubstr("adaptive Gauss-Hermite"), HasSubstr("Clark 1973")));
    const json report = json::parse(json_report(analysis))["hypotheses"];
    EXPECT_EQ(report["H1"]["model"]["quadrature_nodes"], kMixedNodes);
    EXPECT_EQ(report["H1"]["model"]["effect"]["log_odds"].get<double>(), model.effect->log_odds);
    EXPECT_TRUE(report["H3"]["comparisons"][0]["model"].contains("effect"));
}

TEST(ModelCheck, OfThreeLevelsIsTheLikelihoodRatioOfTheirTerms) {
    base::Random random(11);
    std::string text =
        "observer,study,condition,scene,validity,hypothesis,condition_A,condition_B,is_A_"
        "selected\n";
    for (int who = 0; who < 300; ++who) {
        for (const auto& [level, share] :
             {std::pair("low", .4), std::pair("moderate", .5), std::pair("high", .7)}) {
            text += fmt::format("p{},jakobsen2010,c{},hall,{},H1,None,Blizzard24,{:d}\n", who,
                                level, level, random.uniform(0.0, 1.0) >= share);
        }
    }
    const Analysis analysis =
        analyse(tally_of(parse_trials(text, "t.csv"), "", Kind::kParticipant), {.model = true});
    const Comparison& comparison = analysis.validity->by_level.at(0);
    ASSERT_EQ(comparison.levels.size(), 3U);
    ASSERT_TRUE(comparison.model.has_value()) << comparison.model.reason;
    EXPECT_FALSE(comparison.model->effect.has_value());
    EXPECT_EQ(comparison.model->conditions_differ->df, 2);
    // Nobody hangs together: the ratio is that of the counts, near their chi-square.
    EXPECT_NEAR(comparison.model->conditions_differ->statistic, comparison.test->statistic, 1.5);
    EXPECT_THAT(text_report(analysis), HasSubstr("levels differ: likelihood ratio"));
}

TEST(ModelCheck, IsLeftOutUnlessAskedFor) {
    const Analysis analysis = analyse(
        tally_of(parse_trials(answers_of(12, 0.0, 1.0, 0.0, 1), "t.csv"), "", Kind::kParticipant));
    EXPECT_EQ(analysis.hypotheses.at(0).model.reason, "not asked for");
    EXPECT_THAT(text_report(analysis), testing::Not(HasSubstr("Gauss-Hermite")));
}

}  // namespace
}  // namespace obscura::analysis
