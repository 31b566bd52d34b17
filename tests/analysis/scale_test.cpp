// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>

#include "analysis/statistics/bradley_terry.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/mean_test.h"
#include "analysis/statistics/order_bias.h"
#include "analysis/statistics/thurstone.h"
#include "renderer/base/error.h"
#include "tests/analysis/edge_inputs.h"

namespace obscura::analysis {
namespace {

using testing::HasSubstr;

/// Which of two bottles is heavier? Fifty subjects, all pairs of five weights in both orders
/// (Beaver and Gokhale 1975; the table of Davidson and Beaver 1977, p. 699, as in the R package
/// eba). Row chosen over column; above the diagonal the row was lifted first.
using Table = std::array<std::array<int, 5>, 5>;
constexpr Table kRowFirst{{{0, 14, 6, 2, 1},
                           {36, 0, 14, 7, 2},
                           {44, 36, 0, 12, 5},
                           {48, 43, 38, 0, 10},
                           {49, 48, 45, 40, 0}}};
constexpr Table kColumnFirst{{{0, 18, 14, 3, 3},
                              {32, 0, 16, 7, 4},
                              {36, 34, 0, 16, 10},
                              {47, 43, 34, 0, 22},
                              {47, 46, 40, 28, 0}}};
const std::vector<std::string> kBottles{"90g", "95g", "100g", "105g", "110g"};

std::vector<PairVotes> heaviness_pairs() {
    std::vector<PairVotes> pairs;
    for (std::size_t row = 0; row < 5; ++row) {
        for (std::size_t column = row + 1; column < 5; ++column) {
            pairs.push_back({row, column, kRowFirst[row][column], kRowFirst[column][row], -1});
            pairs.push_back({row, column, kColumnFirst[row][column], kColumnFirst[column][row], 1});
        }
    }
    return pairs;
}

TEST(BradleyTerryWithOrder, MeetsTheWeightsOfDavidsonAndBeaver) {
    const auto pairs = heaviness_pairs();
    std::int64_t second_chosen = 0;
    for (const PairVotes& pair : pairs) {
        second_chosen += pair.order_side > 0 ? pair.one_chosen : pair.other_chosen;
    }
    EXPECT_EQ(second_chosen, 540);
    EXPECT_NEAR(exact_binomial(second_chosen, 1000)->p, .012444, 5e-7);
    const auto without = bradley_terry(kBottles, pairs);
    const auto with = bradley_terry_with_order(kBottles, pairs);
    ASSERT_TRUE(without.has_value() && with.has_value()) << without.reason << with.reason;
    const double ratio = 2.0 * (with->log_likelihood - without->log_likelihood);
    EXPECT_NEAR(ratio, 11.5502, 5e-5);
    EXPECT_NEAR(chi_square_tail(ratio, 1).p, .000677, 5e-7);
    EXPECT_GT(with->order_term, 0.0) << "the second bottle seems heavier";
}

TEST(OrderBias, OfTheWeightsAgreesWithTheScaleWithOrder) {
    std::vector<OrderStratum> strata;
    for (std::size_t row = 0; row < 5; ++row) {
        for (std::size_t column = row + 1; column < 5; ++column) {
            strata.push_back({{kRowFirst[row][column], kRowFirst[column][row]},
                              {kColumnFirst[row][column], kColumnFirst[column][row]}});
        }
    }
    const auto test = order_bias(strata);
    const auto scale = bradley_terry_with_order(kBottles, heaviness_pairs());
    ASSERT_TRUE(test.has_value()) << test.reason;
    EXPECT_EQ(test->conditions, 10);
    // Ten free pairs instead of four differences between five bottles: close, not equal.
    EXPECT_NEAR(test->order_term, scale->order_term, .1 * scale->order_standard_error);
    EXPECT_NEAR(test->likelihood_ratio.statistic, 11.55, .3);
}

TEST(OrderBias, OfOneConditionWithMirroredVotesHasAClosedForm) {
    // B chosen 30 of 40 when second and 10 of 40 when first: the condition's term is 0, the order
    // term log 3, its information 2 * 40 * 3/16, the ratio 2 * 80 (log 2 - entropy of 1/4).
    const auto test = order_bias({{{10, 30}, {30, 10}}});
    EXPECT_NEAR(test->order_term, std::log(3.0), 1e-9);
    EXPECT_NEAR(test->second_share, .75, 1e-9);
    EXPECT_NEAR(test->standard_error, 1.0 / std::sqrt(15.0), 1e-9);
    const double entropy = -.25 * std::log(.25) - .75 * std::log(.75);
    EXPECT_NEAR(test->likelihood_ratio.statistic, 160.0 * (std::log(2.0) - entropy), 1e-9);
}

TEST(OrderBias, IsNotMisledByAPreferenceInAnUnbalancedOrder) {
    // B is liked by 90 % in either order and was mostly second; the raw count sees a bias.
    const auto test = order_bias({{{10, 90}, {1, 9}}});
    EXPECT_NEAR(test->order_term, 0.0, 1e-9);
    EXPECT_NEAR(test->likelihood_ratio.p.p, 1.0, 1e-6);
}

TEST(OrderBias, SaysSeparationAndConditionsThatTellNothing) {
    EXPECT_THAT(order_bias({}).reason, HasSubstr("no condition was shown in both orders"));
    EXPECT_THAT(order_bias({{{3, 4}, {0, 0}}}).reason, HasSubstr("no condition was shown"));
    EXPECT_THAT(order_bias({{{0, 5}, {0, 6}}}).reason, HasSubstr("chosen both ways"));
    EXPECT_THAT(order_bias({{{0, 5}, {5, 0}}}).reason, HasSubstr("separated"));
    EXPECT_THAT(order_bias({{{0, 5}, {3, 2}}}).reason, HasSubstr("separated")) << "one zero cell";
    EXPECT_THAT(order_bias({{{5, 0}, {0, 5}}}).reason, HasSubstr("separated"));
    // Another condition with all four cells settles it; one in a single order changes nothing.
    const OrderStratum full{{2, 3}, {3, 2}};
    EXPECT_TRUE(order_bias({{{0, 5}, {3, 2}}, full}).has_value());
    EXPECT_EQ(order_bias({full, {{3, 4}, {0, 0}}})->order_term, order_bias({full})->order_term);
    EXPECT_EQ(order_bias({full, {{3, 4}, {0, 0}}})->conditions, 1);
}

TEST(OrderBias, HasAProperValueOrAReasonAtTheEdges) {
    for (const Votes& one : tests::kEdgeVotes) {
        for (const Votes& other : tests::kEdgeVotes) {
            SCOPED_TRACE(std::to_string(one.a) + ":" + std::to_string(one.b) + " and " +
                         std::to_string(other.a) + ":" + std::to_string(other.b));
            const auto test = order_bias({{one, other}});
            if (!test.has_value()) {
                EXPECT_THAT(test.reason, testing::Not(HasSubstr("settle")));
                continue;
            }
            EXPECT_TRUE(std::isfinite(test->order_term) && test->standard_error > 0.0);
            EXPECT_TRUE(tests::is_proper(test->likelihood_ratio.p));
        }
    }
    for (const Votes& votes : tests::kImpossibleVotes) {
        EXPECT_THROW((void)order_bias({{votes, {1, 1}}}), base::Error);
    }
}

TEST(BradleyTerry, MeetsTheCitationsBetweenFourJournals) {
    // Stigler 1994, table 5: how often the row was cited by the column counts as the row's win
    // (R package BradleyTerry2, data citations, whose vignette prints these values).
    const std::vector<std::string> journals{"Biometrika", "Comm. Statist.", "JASA", "JRSS-B"};
    constexpr std::array<std::array<int, 4>, 4> cited{
        {{714, 730, 498, 221}, {33, 425, 68, 17}, {320, 813, 1072, 142}, {284, 276, 325, 188}}};
    std::vector<PairVotes> pairs;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) pairs.push_back({i, j, cited[i][j], cited[j][i]});
    }
    const auto scale = bradley_terry(journals, pairs);
    ASSERT_TRUE(scale.has_value()) << scale.reason;
    const std::array<double, 4> values{0.0, -2.949072, -.479570, .268954};
    const std::array<double, 4> errors{0.0, .102545, .060589, .070830};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(scale->values[i], values[i], 1e-6) << journals[i];
        EXPECT_NEAR(scale->standard_errors[i], errors[i], 1e-6) << journals[i];
    }
    const auto from_jasa = bradley_terry(journals, pairs, 2);
    EXPECT_EQ(from_jasa->values[2], 0.0);
    EXPECT_NEAR(from_jasa->values[3] - from_jasa->values[0], .268954, 1e-6);
    EXPECT_NEAR(from_jasa->standard_errors[0], .060589, 1e-6);
}

TEST(ThurstoneJod, OneUnitIsThreeQuartersOfTheChoices) {
    const auto scale = thurstone_jod({"none", "some"}, {{0, 1, 25, 75}});
    ASSERT_TRUE(scale.has_value()) << scale.reason;
    EXPECT_NEAR(scale->values[1], 1.0, 1e-9);
    // Delta method: sqrt(p (1 - p) / n) / (phi(q) q), q = Phi^-1(.75) = .6744897502.
    const double q = .6744897501960817;
    const double density = std::exp(-q * q / 2.0) / std::sqrt(2.0 * std::numbers::pi);
    EXPECT_NEAR(scale->standard_errors[1], std::sqrt(.25 * .75 / 100.0) / (density * q), 1e-9);
    EXPECT_NEAR(thurstone_jod({"none", "some"}, {{0, 1, 50, 50}})->values[1], 0.0, 1e-12);
}

TEST(ThurstoneJod, AddsUpAlongAChain) {
    // Each next thing is chosen by 75 %, so that the ends are 2 JOD apart: 91.1328 % would choose.
    const auto scale = thurstone_jod({"a", "b", "c"}, {{0, 1, 25, 75}, {1, 2, 25, 75}});
    EXPECT_NEAR(scale->values[2], 2.0, 1e-9);
    const auto closed =
        thurstone_jod({"a", "b", "c"}, {{0, 1, 2'500'000, 7'500'000},
                                        {1, 2, 2'500'000, 7'500'000},
                                        {0, 2, 886'718, 9'113'282}});  // 1e7 Phi(2 q), rounded
    EXPECT_NEAR(closed->values[1], 1.0, 1e-5);
    EXPECT_NEAR(closed->values[2], 2.0, 1e-5);
}

TEST(PairedScales, SayDisconnectionAndSeparation) {
    const std::vector<std::string> things{"None", "Crytek24", "Blizzard8", "RayMarching30"};
    const std::vector<PairVotes> apart{{0, 1, 3, 4}, {2, 3, 5, 6}};
    EXPECT_EQ(bradley_terry(things, apart).reason,
              "no pair connects (None, Crytek24) with (Blizzard8, RayMarching30)");
    EXPECT_EQ(thurstone_jod(things, apart).reason, bradley_terry(things, apart).reason);
    EXPECT_THAT(connected_groups(4, apart),
                testing::ElementsAre(testing::ElementsAre(0, 1), testing::ElementsAre(2, 3)));
    const std::vector<std::string> three{"None", "Crytek24", "Blizzard24"};
    EXPECT_EQ(bradley_terry(three, {{0, 1, 3, 4}, {1, 2, 0, 5}}).reason,
              "the votes are separated: (Blizzard24) was always chosen over (None, Crytek24)");
    EXPECT_EQ(bradley_terry(three, {{0, 1, 9, 0}, {1, 2, 2, 5}}).reason,
              "the votes are separated: (None) was always chosen over (Crytek24, Blizzard24)");
    EXPECT_TRUE(bradley_terry(three, {{0, 1, 9, 0}, {1, 2, 5, 0}, {0, 2, 0, 5}}).has_value())
        << "a circle of choices has a scale";
    EXPECT_EQ(bradley_terry({"None"}, {}).reason, "fewer than two to compare");
    EXPECT_THAT(bradley_terry_with_order(three, {{0, 1, 3, 4}, {1, 2, 2, 5}}).reason,
                HasSubstr("do not settle"))
        << "no pair tells its order";
}

/// Three votes of each participant on one pair.
VotesOfEach three_votes_each(const std::vector<int>& for_one) {
    VotesOfEach each;
    for (const int chosen : for_one) {
        for (int i = 0; i < 3; ++i) each.votes.push_back({0, i < chosen});
        each.begin.push_back(each.votes.size());
    }
    return each;
}

TEST(ParticipantsErrors, OfOnePairAreThoseOfTheShareOverParticipants) {
    const std::vector<int> for_one{0, 1, 3, 3, 2, 3, 0, 3, 2, 3, 1, 3};
    std::vector<double> shares;
    for (const int chosen : for_one) shares.push_back(chosen / 3.0);
    const std::vector<PairVotes> pairs{{0, 1, 24, 12}};
    const ScaleOptions options{ScaleLink::kLogistic, 1};
    const auto plain = fit_scale({"x", "y"}, pairs, options);
    const auto robust = with_participants_errors(*plain, pairs, options, three_votes_each(for_one));
    EXPECT_NEAR(robust->values[0], std::log(2.0), 1e-9);
    // d logit / d share = 1 / (2/3 1/3).
    EXPECT_NEAR(robust->standard_errors[0], mean_test(shares)->standard_error * 9.0 / 2.0, 1e-9);
    EXPECT_NEAR(plain->standard_errors[0], 1.0 / std::sqrt(36.0 * 2.0 / 9.0), 1e-9);
    EXPECT_EQ(robust->standard_errors[1], 0.0);
    EXPECT_FALSE(with_participants_errors(*plain, pairs, options, {}).has_value());
    EXPECT_THROW((void)with_participants_errors(*plain, pairs, options, {{{1, true}}, {0, 1}}),
                 base::Error);
}

TEST(MaximumAPosteriori, OfSeparatedVotesSolvesItsEquation) {
    const std::vector<PairVotes> pairs{{0, 1, 9, 0}};
    ScaleOptions options{ScaleLink::kLogistic, 1};
    EXPECT_THAT(fit_scale({"x", "y"}, pairs, options).reason, HasSubstr("separated"));
    options.prior_sd = 2.0;
    const auto scale = fit_scale({"x", "y"}, pairs, options);
    ASSERT_TRUE(scale.has_value()) << scale.reason;
    const double value = scale->values[0];
    EXPECT_NEAR(9.0 / (1.0 + std::exp(value)), value / 4.0, 1e-8);
    const double share = 1.0 / (1.0 + std::exp(-value));
    EXPECT_NEAR(scale->standard_errors[0], 1.0 / std::sqrt(9.0 * share * (1.0 - share) + 1.0 / 4.0),
                1e-8);
    // The two orders of showing of a pair are one difference, held once.
    const auto parted = fit_scale({"x", "y"}, {{0, 1, 5, 0, 1}, {0, 1, 4, 0, -1}}, options);
    EXPECT_NEAR(parted->values[0], value, 1e-8);
    EXPECT_THAT(fit_scale({"x", "y", "z"}, pairs, options).reason, HasSubstr("no pair connects"));
}

TEST(PairedScales, HaveFiniteValuesOrAReasonAtTheEdges) {
    for (const Votes& one : tests::kEdgeVotes) {
        for (const Votes& other : tests::kEdgeVotes) {
            SCOPED_TRACE(std::to_string(one.a) + ":" + std::to_string(one.b) + " and " +
                         std::to_string(other.a) + ":" + std::to_string(other.b));
            const std::vector<PairVotes> pairs{{0, 1, one.a, one.b}, {1, 2, other.a, other.b}};
            for (const auto& scale :
                 {bradley_terry({"x", "y", "z"}, pairs), thurstone_jod({"x", "y", "z"}, pairs)}) {
                const bool all_mixed = one.a > 0 && one.b > 0 && other.a > 0 && other.b > 0;
                ASSERT_EQ(scale.has_value(), all_mixed) << scale.reason;
                if (!all_mixed) continue;
                for (std::size_t i = 0; i < 3; ++i) {
                    EXPECT_TRUE(std::isfinite(scale->values[i]));
                    EXPECT_TRUE(std::isfinite(scale->standard_errors[i]));
                }
                EXPECT_GT(scale->standard_errors[1], 0.0);
            }
        }
    }
    for (const Votes& votes : tests::kImpossibleVotes) {
        EXPECT_THROW((void)bradley_terry({"x", "y"}, {{0, 1, votes.a, votes.b}}), base::Error);
    }
    EXPECT_THROW((void)bradley_terry({"x", "y"}, {{0, 2, 1, 1}}), base::Error);
    EXPECT_THROW((void)bradley_terry({"x", "y"}, {{1, 1, 1, 1}}), base::Error);
    EXPECT_THROW((void)bradley_terry({"x", "y"}, {{0, 1, 1, 1}}, 2), base::Error);
}

}  // namespace
}  // namespace obscura::analysis
