// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/pooled_share.h"
#include "analysis/counts_file.h"
#include "analysis/presentation/json_report.h"
#include "analysis/statistics/clopper_pearson.h"
#include "analysis/statistics/clustered_share.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/mean_test.h"
#include "analysis/statistics/participants_posterior.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"
#include "tests/analysis/edge_inputs.h"

namespace obscura::analysis {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Three votes of each participant, so many of them for B.
const std::vector<int> kForB{0, 1, 3, 3, 2, 3, 0, 3, 2, 3, 1, 3};

std::vector<Votes> three_each() {
    std::vector<Votes> each;
    for (const int for_b : kForB) each.push_back({3 - for_b, for_b});
    return each;
}

TEST(ClusteredShare, OfAsManyVotesEachIsTheIntervalOfTheMeanOfTheirShares) {
    std::vector<double> shares;
    for (const int for_b : kForB) shares.push_back(for_b / 3.0);
    for (const double confidence : {.90, .95}) {
        const auto interval = clustered_share(three_each(), confidence);
        const auto mean = mean_test(shares, confidence);
        EXPECT_NEAR(interval->low, mean->interval.low, 1e-14);
        EXPECT_NEAR(interval->high, mean->interval.high, 1e-14);
    }
}

TEST(ClusteredShare, HasNoValueWhereNothingVariesAndPassesOverWhoDidNotVote) {
    EXPECT_EQ(clustered_share({}).reason, "fewer than two participants");
    EXPECT_EQ(clustered_share({{1, 2}, {0, 0}}).reason, "fewer than two participants");
    EXPECT_EQ(clustered_share({{1, 2}, {2, 4}}).reason, "no participant differs from the others");
    EXPECT_EQ(clustered_share({{0, 2}, {0, 1}}).reason, "no participant differs from the others");
    std::vector<Votes> more = three_each();
    more.insert(more.begin() + 3, {0, 0});
    EXPECT_EQ(clustered_share(more)->low, clustered_share(three_each())->low);
    EXPECT_THROW((void)clustered_share({{1, 1}}, 1.0), base::Error);
    for (const Votes& votes : tests::kImpossibleVotes) {
        EXPECT_THROW((void)clustered_share({{1, 1}, votes}), base::Error);
    }
}

TEST(ParticipantsPosterior, OfOneVoteEachIsTheFlatPosterior) {
    std::vector<Votes> each(14, {1, 0});
    each.insert(each.end(), 22, {0, 1});
    const auto posterior = participants_posterior(each);
    EXPECT_NEAR(posterior->mean, .605263, 5e-7);
    EXPECT_NEAR(posterior->interval.low, .447568, 5e-7);
    EXPECT_NEAR(posterior->interval.high, .752458, 5e-7);
    EXPECT_NEAR(posterior->above_half.p, .906129, 5e-7);
}

TEST(ParticipantsPosterior, MeetsTheDoubleIntegral) {
    // R's integrate() over the share and the correlation of beta binomial votes.
    const auto posterior = participants_posterior(three_each());
    EXPECT_NEAR(posterior->mean, .6510877, 1e-5);
    EXPECT_NEAR(posterior->interval.low, .43557222, 2e-5);
    EXPECT_NEAR(posterior->interval.high, .83514857, 2e-5);
    EXPECT_NEAR(posterior->above_half.p, .9197224, 1e-5);
}

TEST(ParticipantsPosterior, IsNearTheFlatOneOfVotesThatDoNotHangTogetherAndWideOfThoseThatDo) {
    std::vector<Votes> apart;
    std::vector<Votes> alike;
    for (int who = 0; who < 400; ++who) {
        // Numbers of three coins, in their proportions 1 : 3 : 3 : 1.
        const int for_b = std::array{0, 1, 1, 1, 2, 2, 2, 3}.at(static_cast<std::size_t>(who % 8));
        apart.push_back({3 - for_b, for_b});
        alike.push_back(who % 2 == 0 ? Votes{3, 0} : Votes{0, 3});
    }
    const auto width = [](const Possible<Posterior>& posterior) {
        return posterior->interval.high - posterior->interval.low;
    };
    const double coins = width(posterior_flat(600, 1200));
    EXPECT_NEAR(width(participants_posterior(apart)) / coins, 1.0, .05);
    EXPECT_NEAR(width(participants_posterior(alike)) / coins, std::sqrt(3.0), .05);
}

/// So many participants with none, one, two and three of three votes for B.
std::vector<Votes> with_for_b(const std::array<int, 4>& participants) {
    std::vector<Votes> each;
    for (int for_b = 0; for_b < 4; ++for_b) {
        each.insert(each.end(),
                    static_cast<std::size_t>(participants.at(static_cast<std::size_t>(for_b))),
                    Votes{3 - for_b, for_b});
    }
    return each;
}

TEST(ParticipantsPosterior, IsANumberForSharesWhoseDensityIsSoughtAsFarAsOne) {
    // Sums over 401 shares and 300 correlations in double precision.
    const auto posterior = participants_posterior(with_for_b({3, 31, 51, 35}));
    EXPECT_NEAR(posterior->mean, .65933, 5e-4);
    EXPECT_NEAR(posterior->interval.low, .608, 1.5e-3);
    EXPECT_NEAR(posterior->interval.high, .709, 1.5e-3);
    for (int with_one = 10; with_one < 90; ++with_one) {
        const auto other = participants_posterior(with_for_b({4, with_one, 50, 30}));
        EXPECT_TRUE(std::isfinite(other->mean)) << with_one;
        EXPECT_LT(other->interval.low, other->mean) << with_one;
        EXPECT_GT(other->interval.high, other->mean) << with_one;
    }
}

TEST(ParticipantsPosterior, HasProperValuesOrAReasonAtTheEdges) {
    EXPECT_EQ(participants_posterior({}).reason, "no votes");
    for (const Votes& votes : tests::kEdgeVotes) {
        const auto posterior = participants_posterior({votes, {1, 2}, {0, 2}});
        EXPECT_GT(posterior->interval.low, 0.0);
        EXPECT_LT(posterior->interval.low, posterior->interval.high);
        EXPECT_LE(posterior->interval.high, 1.0);
        EXPECT_TRUE(posterior->mean > posterior->interval.low &&
                    posterior->mean < posterior->interval.high);
    }
    std::vector<Votes> different;
    for (int i = 0; i < 400; ++i) different.push_back({i, 2});
    EXPECT_THAT(participants_posterior(different).reason, HasSubstr("too many"));
    EXPECT_THROW((void)participants_posterior({{1, 1}}, 0.0), base::Error);
}

TEST(ExactBinomialOfAShare, IsTheExactTestOfWholeNumbersAndNeverContradictsItsInterval) {
    for (int n = 1; n <= 40; ++n) {
        for (int k = 0; k <= n; ++k) {
            const double share = static_cast<double>(k) / n;
            EXPECT_NEAR(exact_binomial_of_share(share, n)->p, exact_binomial(k, n)->p, 1e-12);
        }
        for (int third = 0; third <= 3 * n; ++third) {
            const double share = third / (3.0 * n);
            const auto interval = clopper_pearson_of_share(share, n);
            const bool excludes = interval->low > .5 || interval->high < .5;
            EXPECT_EQ(exact_binomial_of_share(share, n)->p < .05, excludes) << share << " of " << n;
        }
    }
    // R: 2 * pbeta(.5, 36 * 62 / 108, 36 - 36 * 62 / 108 + 1).
    EXPECT_NEAR(exact_binomial_of_share(62.0 / 108.0, 36)->p, .4706911335, 1e-9);
    EXPECT_FALSE(exact_binomial_of_share(.5, 0).has_value());
    EXPECT_THROW((void)exact_binomial_of_share(1.5, 3), base::Error);
}

/// Votes of three conditions; the first always A, so that they differ.
Analysis of_three_conditions(const std::vector<int>& for_b, bool first_always_a) {
    std::string text = "observer,condition,hypothesis,condition_A,condition_B,is_A_selected\n";
    for (std::size_t who = 0; who < for_b.size(); ++who) {
        for (int i = 0; i < 3; ++i) {
            const bool chose_b = i >= 3 - for_b[who] && !(first_always_a && i == 0);
            text += fmt::format("p{},c{},H1,None,Blizzard24,{:d}\n", who, i, !chose_b);
        }
    }
    return analyse(tally_of(parse_trials(text, "t.csv"), "", Kind::kParticipant));
}

TEST(PooledShare, HasOneIntervalAndNoNumberThatTakesVotesAsIndependentBesideIt) {
    const Analysis analysis = of_three_conditions(kForB, false);
    const HypothesisResult& h1 = analysis.hypotheses.at(0);
    EXPECT_EQ(h1.interval->kind, ShareIntervalKind::kMeans);
    EXPECT_NEAR(h1.interval->bounds.low, clustered_share(three_each())->low, 1e-15);
    EXPECT_FALSE(h1.pooled.wilson.has_value());
    EXPECT_FALSE(h1.pooled.clopper_pearson.has_value());
    EXPECT_FALSE(h1.pooled.bayes_factor.has_value());
    EXPECT_NEAR(h1.posterior->mean, .6510877, 1e-5);
    const json report = json::parse(json_report(analysis))["hypotheses"]["H1"];
    EXPECT_TRUE(report["wilson_low"].is_null());
    EXPECT_EQ(report["share_b_interval_from"], "t_of_participants");
    EXPECT_EQ(report["take_votes_as_independent"][0], "chi_square");
}

TEST(PooledShare, OfOneVoteEachIsTheExactTestWithItsInterval) {
    std::string text = "observer,condition,hypothesis,condition_A,condition_B,is_A_selected\n";
    for (int who = 0; who < 36; ++who) {
        text += fmt::format("p{},c,H1,None,Blizzard24,{:d}\n", who, who < 11);
    }
    const Analysis analysis =
        analyse(tally_of(parse_trials(text, "t.csv"), "", Kind::kParticipant));
    const HypothesisResult& h1 = analysis.hypotheses.at(0);
    EXPECT_NEAR(p_of(h1)->p, .028817, 5e-7);
    EXPECT_EQ(h1.interval->kind, ShareIntervalKind::kEachOnce);
    EXPECT_NEAR(h1.interval->bounds.low, clopper_pearson(25, 36)->low, 1e-12);
    EXPECT_TRUE(h1.pooled.wilson.has_value());
    EXPECT_NEAR(h1.posterior->above_half.p, .989963, 5e-7);
}

TEST(PooledShare, OfCountsCountsEachParticipantOnce) {
    const Analysis analysis =
        analyse(parse_counts("condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n"
                             "II,H1,low,None,Blizzard24,14,22\nV,H1,low,None,Blizzard24,11,25\n",
                             "c.csv"));
    const HypothesisResult& h1 = analysis.hypotheses.at(0);
    // 47 of 72 votes, as if 36 people had voted once: 25:47 of independent votes had p .0124.
    EXPECT_NEAR(p_of(h1)->p, exact_binomial_of_share(47.0 / 72.0, 36)->p, 1e-15);
    EXPECT_GT(p_of(h1)->p, .05);
    EXPECT_LT(h1.interval->bounds.low, .5) << "as its interval says";
    EXPECT_FALSE(h1.posterior.has_value());
}

TEST(Heterogeneity, OfConditionsIsCochransQOfTheSameParticipants) {
    const Analysis same = of_three_conditions(kForB, false);
    const Analysis other = of_three_conditions(std::vector<int>(12, 3), true);
    EXPECT_EQ(other.hypotheses.at(0).heterogeneity->participants, 12);
    // Everybody A, B, B: L = 2 of 3, Q = 3 * 2 * (8^2 + 4^2 + 4^2) / (12 * 2) = 24.
    EXPECT_NEAR(other.hypotheses.at(0).heterogeneity->test.statistic, 24.0, 1e-9);
    EXPECT_EQ(other.hypotheses.at(0).heterogeneity->test.df, 2);
    EXPECT_LT(same.hypotheses.at(0).heterogeneity->test.statistic, 24.0);
}

}  // namespace
}  // namespace obscura::analysis
