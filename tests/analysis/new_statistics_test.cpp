// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/fisher_exact.h"
#include "analysis/statistics/group_permutation.h"
#include "analysis/statistics/hard_cases.h"
#include "analysis/statistics/mean_test.h"
#include "analysis/statistics/preference_curve.h"
#include "analysis/statistics/share_difference.h"
#include "analysis/statistics/sign_flip.h"
#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "tests/analysis/edge_inputs.h"

namespace obscura::analysis {
namespace {

using testing::HasSubstr;

TEST(StatisticsHardCases, AllHold) {
    const auto cases = statistics_hard_cases();
    EXPECT_EQ(cases.size(), 39U);
    for (const StatisticsCase& one : cases) {
        EXPECT_TRUE(one.holds) << one.name << ", " << one.quantity << ": " << one.measured
                               << " against " << one.expected << " (" << one.note << ")";
        EXPECT_FALSE(one.note.empty());
    }
}

TEST(SignFlip, OfOneVoteEachIsTheExactBinomialTest) {
    for (const int for_b : {0, 3, 5, 8, 11}) {
        std::vector<std::int64_t> differences(11, -1);
        std::fill_n(differences.begin(), for_b, 1);
        EXPECT_NEAR(sign_flip(differences)->p.p, exact_binomial(for_b, 11)->p, 1e-14) << for_b;
    }
}

TEST(SignFlip, EqualsTheShareOfAllFlips) {
    const std::vector<std::int64_t> differences{3, -1, 2, 2, -1, 3, 1, 0};
    int as_far = 0;
    for (unsigned flips = 0; flips < 128; ++flips) {
        std::int64_t sum = 0;
        for (unsigned i = 0; i < 7; ++i)
            sum += (flips >> i & 1U) != 0 ? -differences[i] : differences[i];
        if (std::abs(sum) >= 9) ++as_far;
    }
    const auto test = sign_flip(differences);
    EXPECT_EQ(test->sum, 9);
    EXPECT_EQ(test->participants, 7);
    EXPECT_NEAR(test->p.p, as_far / 128.0, 1e-15);
    EXPECT_FALSE(sign_flip({}).has_value());
    EXPECT_FALSE(sign_flip({0, 0}).has_value());
    EXPECT_EQ(sign_flip({1'000})->p.p, 1.0) << "one participant says nothing";
    EXPECT_THROW((void)sign_flip({2'000'000}), base::Error);
}

TEST(SignFlip, TheNormalApproximationAgreesWithTheExactTestWhereItBegins) {
    std::vector<std::int64_t> differences;
    for (int i = 0; i < 1000; ++i) differences.push_back(i % 20 < 11 ? 1 : -1);
    const double exact = sign_flip(differences)->p.p;
    differences.push_back(1);
    differences.push_back(-1);
    const auto large = sign_flip(differences);
    EXPECT_FALSE(large->is_exact);
    // Sums lie 2 apart, of a standard deviation of 31.6: half a step at 3.2 of them is 10 %.
    EXPECT_NEAR(large->p.p / exact, 1.0, .1);
}

TEST(ShareDifference, MeetsNewcombesExample) {
    // R. G. Newcombe 1998, table II, method 10: 56/70 less 48/80 is .2, .0524 to .3339.
    const auto bounds = share_difference({32, 48}, {14, 56});
    EXPECT_NEAR(bounds->low, .0524, 5e-5);
    EXPECT_NEAR(bounds->high, .3339, 5e-5);
    EXPECT_EQ(share_difference({0, 0}, {1, 1}).reason, "no votes");
}

TEST(Quartiles, AreThoseOfType7) {
    std::vector<double> sample{9.0, 1.0, 4.0, 2.0};  // R: quantile(c(9, 1, 4, 2)) 1.75 3 5.25
    const auto parts = quartiles(sample);
    EXPECT_EQ(parts->first, 1.75);
    EXPECT_EQ(parts->median, 3.0);
    EXPECT_EQ(parts->third, 5.25);
    std::vector<double> bad{1.0, std::nan("")};
    EXPECT_THROW((void)quartiles(bad), base::Error);
    EXPECT_FALSE(median_interval({1, 2, 3, 4, 5}).has_value()) << "2 / 2^5 is above .05";
    EXPECT_EQ(median_interval({1, 2, 3, 4, 5, 6})->low, 1.0);
    EXPECT_EQ(median_interval({1, 2, 3, 4, 5, 6})->high, 6.0);
}

TEST(MedianSlope, IsNotMovedByAWildPoint) {
    std::vector<std::pair<double, double>> line;
    for (int i = 0; i < 100; ++i) line.emplace_back(i, 3.0 - .5 * i);
    line[40].second = 1e6;
    EXPECT_NEAR(*median_slope(line), -.5, 1e-12);
    line.resize(7);
    EXPECT_NEAR(*median_slope(line), -.5, 1e-12);
    EXPECT_FALSE(median_slope({{1.0, 2.0}, {1.0, 3.0}}).has_value());
}

TEST(PreferenceCurve, OfMirroredPointsHasAClosedForm) {
    // 3 to 1 at a difference of -2, 1 to 3 at 2 and even at 0: logit(3/4) = ln 3 for two units.
    const auto curve = preference_curve(
        {{"I", "low", -2.0, {10, 30}}, {"II", "low", 2.0, {30, 10}}, {"III", "high", 0.0, {5, 5}}});
    ASSERT_TRUE(curve.overall.has_value()) << curve.overall.reason;
    const double ln3 = std::log(3.0);
    EXPECT_NEAR(curve.overall->slope, -ln3 / 2.0, 1e-12);
    EXPECT_NEAR(*curve.overall->difference_75, -2.0, 1e-12);
    // Information: sum of n x^2 p (1 - p) = 80 * 4 * 3 / 16.
    EXPECT_NEAR(curve.overall->standard_error, 1.0 / std::sqrt(60.0), 1e-12);
    // Deviance against slope 0: 2 * 80 * (ln 2 + (3 ln 3 - 4 ln 4) / 4).
    EXPECT_NEAR(curve.overall->likelihood_ratio.statistic,
                160.0 * (std::numbers::ln2 + .75 * ln3 - 2.0 * std::numbers::ln2), 1e-9);
    EXPECT_NEAR(curve.overall->lack_of_fit->statistic, 0.0, 1e-9);
    EXPECT_NEAR(curve.overall->share_b(-2.0), .75, 1e-12);
    const auto& ends = curve.overall->slope_interval;
    EXPECT_LT(ends.low, curve.overall->slope);
    EXPECT_LT(curve.overall->slope, ends.high);
    EXPECT_LT(ends.high, 0.0);
    EXPECT_NEAR(curve.overall->difference_75_interval->low, ln3 / ends.high, 1e-12);
    ASSERT_EQ(curve.by_validity.size(), 2U);
    EXPECT_EQ(curve.by_validity[0].first, "low");
    EXPECT_THAT(curve.by_validity[0].second.reason, HasSubstr("same amount"));
    EXPECT_THAT(curve.by_validity[1].second.reason, HasSubstr("differ"));
}

TEST(PreferenceCurve, TheProfileIntervalEndsWhereTheLikelihoodHasFallenByTheQuantile) {
    const auto fit =
        *preference_curve({{"I", "", -.02, {11, 25}}, {"II", "", .01, {16, 20}}}).overall;
    const auto log_likelihood = [](double slope) {
        const auto log_share = [&](double x) { return -std::log1p(std::exp(-slope * x)); };
        return 25 * log_share(-.02) + 11 * log_share(.02) + 20 * log_share(.01) +
               16 * log_share(-.01);
    };
    for (const double end : {fit.slope_interval.low, fit.slope_interval.high}) {
        EXPECT_NEAR(2.0 * (log_likelihood(fit.slope) - log_likelihood(end)), 3.841458820694124,
                    1e-6);
    }
}

TEST(PreferenceCurve, SaysSeparationAndOpenIntervals) {
    EXPECT_THAT(preference_curve({}).overall.reason, HasSubstr("no votes"));
    EXPECT_THAT(preference_curve({{"I", "", 1.0, {9, 0}}, {"II", "", -2.0, {0, 4}}}).overall.reason,
                HasSubstr("separated: every one is for the image with the smaller value"));
    EXPECT_THAT(preference_curve({{"I", "", 1.0, {9, 4}}}).overall.reason, HasSubstr("one pair"));
    const auto open = preference_curve({{"I", "", 1.0, {18, 17}}, {"II", "", .3, {18, 18}}});
    EXPECT_THAT(open.overall->difference_75_interval.reason, HasSubstr("holds 0"));
    EXPECT_THROW((void)preference_curve({{"I", "", std::nan(""), {1, 1}}}), base::Error);
    for (const Votes& votes : tests::kEdgeVotes) {
        const auto curve = preference_curve({{"I", "", 1.0, votes}, {"II", "", -.5, {3, 4}}});
        if (!curve.overall.has_value()) continue;
        EXPECT_TRUE(std::isfinite(curve.overall->slope) &&
                    std::isfinite(curve.overall->slope_interval.low) &&
                    std::isfinite(curve.overall->slope_interval.high));
    }
    for (const Votes& votes : tests::kImpossibleVotes) {
        EXPECT_THROW((void)preference_curve({{"I", "", 1.0, votes}}), base::Error);
    }
}

TEST(MeanTest, MeetsDarwinsMaize) {
    // R: t.test(c(49, -67, ...)): t = 2.148, df = 14, p-value = 0.0497, 0.03119332 to 41.83547335.
    const std::vector<double> maize{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};
    const auto test = mean_test(maize);
    EXPECT_EQ(test->n, 15);
    EXPECT_NEAR(test->p.p, .049703, 5e-7);
    EXPECT_NEAR(test->interval.low, .03119332, 5e-8);
    EXPECT_NEAR(test->interval.high, 41.83547335, 5e-8);
}

TEST(MeanTest, HasNoValueWhereNothingVaries) {
    EXPECT_EQ(mean_test({}).reason, "fewer than two participants");
    EXPECT_EQ(mean_test({.5}).reason, "fewer than two participants");
    EXPECT_EQ(mean_test({.5, .5, .5}).reason, "all participants gave the same");
    EXPECT_THROW((void)mean_test({.5, std::nan("")}), base::Error);
    EXPECT_THROW((void)mean_test({.5, .7}, 1.0), base::Error);
}

/// How often the 90 % interval of the mean share of three answers each lies within .35 to .65.
double equal_in(int participants, double share, std::uint64_t seed) {
    constexpr int kStudies = 4000;
    base::Random random(seed);
    int equal = 0;
    for (int study = 0; study < kStudies; ++study) {
        std::vector<double> shares;
        for (int who = 0; who < participants; ++who) {
            int chosen = 0;
            for (int i = 0; i < 3; ++i) chosen += random.uniform(0.0, 1.0) < share ? 1 : 0;
            shares.push_back(chosen / 3.0);
        }
        const auto test = mean_test(shares, .90);
        if (test.has_value() && test->interval.low > .35 && test->interval.high < .65) ++equal;
    }
    return static_cast<double>(equal) / kStudies;
}

TEST(MeanTest, SaysPracticallyEqualFalselyInAtMostOneOfTwenty) {
    // By adding up every outcome of 12 and of 36: of a share of .65 in 2.50 and 4.27 %, of one half
    // in 12.0 and 84.2 %.
    struct Case {
        int participants;
        double falsely, rightly;
    };
    for (const Case& known : {Case{12, .0250, .120}, {36, .0427, .842}, {120, .0465, 1.0}}) {
        const auto seed = static_cast<std::uint64_t>(known.participants);
        EXPECT_NEAR(equal_in(known.participants, .65, seed), known.falsely, .010);
        EXPECT_NEAR(equal_in(known.participants, .50, seed), known.rightly, .018);
    }
}

TEST(GroupPermutation, IsTheShareOfAllWaysToPartThem) {
    // Sums of two of 3, 5, 1, 2: 8, 4, 5, 6, 7, 3, expected 5.5; 8 and 3 are as far from it as 8.
    EXPECT_NEAR(group_permutation({3, 5}, {1, 2})->p.p, 2.0 / 6.0, 1e-12);
    EXPECT_NEAR(group_permutation({1, 2}, {3, 5})->p.p, 2.0 / 6.0, 1e-12);
    // 0 and 1 only: Fisher's exact test of 8:2 against 1:9 has the same parting.
    std::vector<std::int64_t> one(10, 0);
    std::vector<std::int64_t> other(10, 0);
    std::fill_n(one.begin(), 8, 1);
    std::fill_n(other.begin(), 1, 1);
    EXPECT_NEAR(group_permutation(one, other)->p.p, fisher_exact({2, 8}, {9, 1})->p, 1e-12);
    EXPECT_EQ(group_permutation({}, {1, 2}).reason, "one of the groups is empty");
    EXPECT_EQ(group_permutation({2, 2}, {2}).reason, "all participants gave the same");
    EXPECT_THROW((void)group_permutation({-1}, {2}), base::Error);
}

TEST(GroupPermutation, IsNearlyTheSameByTheNormalApproximation) {
    base::Random random(5);
    std::vector<std::int64_t> one;
    std::vector<std::int64_t> other;
    for (int i = 0; i < 60; ++i) {
        one.push_back(static_cast<std::int64_t>(random.uniform(0.0, 8.0)));
        other.push_back(static_cast<std::int64_t>(random.uniform(0.0, 7.0)));
    }
    const auto exact = group_permutation(one, other);
    ASSERT_TRUE(exact->is_exact);
    for (auto* group : {&one, &other}) {
        for (std::int64_t& number : *group) number *= 1000;
    }
    const auto nearly = group_permutation(one, other);
    EXPECT_FALSE(nearly->is_exact);
    EXPECT_NEAR(nearly->p.p, exact->p.p, .04);  // sums of the exact one go in steps
}

}  // namespace
}  // namespace obscura::analysis
