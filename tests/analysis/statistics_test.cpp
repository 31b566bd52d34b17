// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <string>

#include "analysis/statistics/benjamini_hochberg.h"
#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/clopper_pearson.h"
#include "analysis/statistics/cohens_g.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/holm.h"
#include "analysis/statistics/wilson.h"
#include "renderer/base/error.h"
#include "tests/analysis/edge_inputs.h"
#include "tests/analysis/table_4.h"

namespace obscura::analysis {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pointwise;

constexpr double kPrinted = 1e-6;

TEST(Table4OfJakobsen2010, IsMetBySevenTests) {
    std::vector<double> p_values;
    std::vector<double> p_holm;
    for (const Table4Row& row : kTable4) {
        SCOPED_TRACE(row.condition);
        const auto chi = chi_square_equal_split(row.votes);
        const auto exact = exact_binomial(row.votes.b, row.votes.n());
        const auto interval = wilson(row.votes.b, row.votes.n());
        const auto g = cohens_g(row.votes);
        ASSERT_TRUE(chi.has_value() && exact.has_value() && interval.has_value() && g.has_value());
        EXPECT_NEAR(chi->statistic, row.chi_square, kPrinted);
        EXPECT_EQ(chi->df, 1);
        EXPECT_NEAR(chi->p.p, row.p, kPrinted);
        EXPECT_NEAR(exact->p, row.p_exact, kPrinted);
        EXPECT_NEAR(interval->low, row.wilson_low, kPrinted);
        EXPECT_NEAR(interval->high, row.wilson_high, kPrinted);
        EXPECT_NEAR(*g, row.cohens_g, kPrinted);
        p_values.push_back(chi->p.p);
        p_holm.push_back(row.p_holm);
    }
    EXPECT_THAT(holm(p_values), Pointwise(DoubleNear(kPrinted), p_holm));
}

TEST(ChiSquare, MeetsSixtyOfHundredAndTheBillion) {
    EXPECT_NEAR(chi_square_equal_split({40, 60})->p.p, .0455, 5e-6);  // 2 * pnorm(-2)
    const auto billion = chi_square_equal_split({500'000'000, 500'100'000});
    EXPECT_NEAR(billion->statistic, 9.99900009999, 1e-11);
    EXPECT_NEAR(billion->p.p, .0015662524434245293, 1e-15);  // mpmath 1.3, 40 digits
}

TEST(ChiSquare, TheTailKeepsItsSizeWhereDoublesEnd) {
    // R: pchisq(2000, 1, lower.tail = FALSE, log.p = TRUE) is -1004.027; more digits by mpmath.
    const PValue far = chi_square_tail(2000.0, 1);
    EXPECT_NEAR(far.log10_p * std::numbers::ln10, -1004.0267419589519, 1e-9);
    EXPECT_NEAR(chi_square_tail(5000.0, 7).log10_p, -1077.7624966070126, 1e-9);
    EXPECT_NEAR(chi_square_tail(3000.0, 100).log10_p, -558.58294227572148, 1e-9);
    EXPECT_NEAR(chi_square_tail(1e6, 1).log10_p, -217150.33901199872, 1e-6);
    for (double statistic = 1380.0; statistic < 1480.0; statistic += 1.0) {  // across the change
        const double step =
            chi_square_tail(statistic + 1.0, 1).log10_p - chi_square_tail(statistic, 1).log10_p;
        EXPECT_NEAR(step, -0.5 / std::numbers::ln10, 2e-4) << statistic;
    }
}

TEST(ChiSquare, HomogeneityAnswersH3FromCounts) {
    // R: chisq.test(..., correct = FALSE). Crytek against Blizzard over low, moderate, high.
    const auto levels = chi_square_homogeneity({{18, 18}, {11, 25}, {18, 18}});
    EXPECT_NEAR(levels->statistic, 3.691664, kPrinted);
    EXPECT_EQ(levels->df, 2);
    EXPECT_NEAR(levels->p.p, .157894, kPrinted);
    const auto atrium = chi_square_homogeneity({{11, 25}, {18, 18}});
    EXPECT_NEAR(atrium->statistic, 2.829190, kPrinted);
    EXPECT_NEAR(atrium->p.p, .092565, kPrinted);
    const auto none = chi_square_homogeneity({{14, 22}, {11, 25}});
    EXPECT_NEAR(none->statistic, .551489, kPrinted);
    EXPECT_NEAR(none->p.p, .457710, kPrinted);
    EXPECT_NEAR(chi_square_equal_split({46, 62})->statistic, 2.370370, kPrinted);  // H1 pooled
    EXPECT_NEAR(chi_square_equal_split({46, 62})->p.p, .123658, kPrinted);
}

TEST(ChiSquare, HomogeneityHasNoValueWithoutTwoRowsOrTwoSides) {
    EXPECT_EQ(chi_square_homogeneity({}).reason, "fewer than two rows have votes");
    EXPECT_EQ(chi_square_homogeneity({{3, 4}, {0, 0}}).reason, "fewer than two rows have votes");
    EXPECT_EQ(chi_square_homogeneity({{0, 4}, {0, 5}}).reason, "all votes are for one side");
    EXPECT_EQ(chi_square_homogeneity({{3, 4}, {0, 0}, {4, 3}})->df, 1);
    EXPECT_NEAR(chi_square_homogeneity({{0, kMaxCount}, {kMaxCount, 0}})->statistic, 2e12, 1.0);
}

TEST(ChiSquare, RefusesStatisticsThatCannotBe) {
    for (const double statistic : {-1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_THROW((void)chi_square_tail(statistic, 1), base::Error);
    }
    EXPECT_THROW((void)chi_square_tail(1.0, 0), base::Error);
}

TEST(ExactBinomial, MeetsPublishedAndExactValues) {
    EXPECT_NEAR(exact_binomial(60, 100)->p, .0568879336409807917, 1e-15);  // R prints .056888
    EXPECT_NEAR(exact_binomial(0, 36)->p, 2.910383e-11, 1e-17);            // R; it is 2^-35
    EXPECT_NEAR(exact_binomial(36, 36)->p, 0x1p-35, 1e-25);
    // Conover 1971, p. 97 (R's example of binom.test prints .3825); the digits are exact rational
    // arithmetic over all 926 outcomes.
    EXPECT_NEAR(exact_binomial(682, 925, 0.75)->p, .3824915595748517, 1e-13);
    EXPECT_NEAR(exact_binomial(3, 10, 0.2)->p, .429574656, 1e-13);
    EXPECT_NEAR(exact_binomial(0, 10, 0.01)->p, 1.0, 1e-13);
    EXPECT_NEAR(exact_binomial(5, 100, 0.25)->p, 1.8338651637565788e-7, 1e-19);
    EXPECT_NEAR(exact_binomial(540, 1000)->p, .012444, 5e-7);  // R package eba, data heaviness
}

TEST(ExactBinomial, EqualsTheSumOverAllOutcomes) {
    for (const double share : {0.5, 0.3, 0.75, 0.01}) {
        for (const int n : {1, 2, 7, 36}) {
            std::vector<double> pmf;
            for (int k = 0; k <= n; ++k) {
                pmf.push_back(std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) -
                                       std::lgamma(n - k + 1.0) + k * std::log(share) +
                                       (n - k) * std::log1p(-share)));
            }
            for (int k = 0; k <= n; ++k) {
                double sum = 0.0;
                for (const double p : pmf) {
                    if (p <= pmf[static_cast<std::size_t>(k)] * (1.0 + 1e-7)) sum += p;
                }
                EXPECT_NEAR(exact_binomial(k, n, share)->p, sum, 1e-12)
                    << k << " of " << n << " against " << share;
            }
        }
    }
}

TEST(ExactBinomial, IsExactAtABillion) {
    // mpmath 1.3, 40 digits, summing the tail.
    EXPECT_NEAR(exact_binomial(500'000'000, 1'000'100'000)->p / .00156642252301815371, 1.0, 1e-9);
    EXPECT_NEAR(exact_binomial(499'000'000, 1'000'000'000)->log10_p, -870.487872499712, 1e-6);
    // Against another share both tails are looked for; .5 and its neighbour hardly differ.
    const double near_half = std::nextafter(0.5, 1.0);
    EXPECT_NEAR(exact_binomial(500'000'000, 1'000'100'000, near_half)->p, .00156642252301815371,
                1e-7);
}

TEST(ExactBinomial, TheTailKeepsItsSizeWhereDoublesEnd) {
    EXPECT_NEAR(exact_binomial(0, 10'000)->log10_p, -9'999 * std::numbers::ln2 / std::numbers::ln10,
                1e-9);
    EXPECT_NEAR(exact_binomial(100, 100'000)->log10_p, -29760.689609829386, 1e-6);
    EXPECT_NEAR(exact_binomial(10'000, 10'000)->log10_p, exact_binomial(0, 10'000)->log10_p, 1e-9);
}

TEST(ExactBinomial, RefusesSharesAndCountsThatCannotBe) {
    for (const double share : tests::kNoProbabilities) {
        EXPECT_THROW((void)exact_binomial(1, 2, share), base::Error) << share;
    }
    EXPECT_THROW((void)exact_binomial(1, 2, 0.0), base::Error);
    EXPECT_THROW((void)exact_binomial(3, 2), base::Error);
    EXPECT_THROW((void)exact_binomial(-1, 2), base::Error);
    EXPECT_THROW((void)exact_binomial(0, -1), base::Error);
}

TEST(Wilson, MeetsThePublishedInterval) {
    const auto interval = wilson(19, 38);
    EXPECT_NEAR(interval->low, .348499, kPrinted);  // R: prop.test(19, 38, correct = FALSE)
    EXPECT_NEAR(interval->high, .651501, kPrinted);
}

TEST(Wilson, TheEndsAreExactAtNoneAndAll) {
    EXPECT_EQ(wilson(0, 36)->low, 0.0);
    EXPECT_GT(wilson(0, 36)->high, 0.0);
    EXPECT_EQ(wilson(36, 36)->high, 1.0);
    EXPECT_LT(wilson(36, 36)->low, 1.0);
}

TEST(Wilson, ABoundIsTheShareThatTheScoreTestJustRejects) {
    // By definition |k - n p| = z sqrt(n p (1 - p)), z the normal quantile of the confidence.
    const auto interval = wilson(11, 36, 0.99);
    for (const double p : {interval->low, interval->high}) {
        EXPECT_NEAR(std::abs(11 - 36 * p), 2.5758293035489004 * std::sqrt(36 * p * (1 - p)), 1e-9);
    }
}

TEST(Wilson, RefusesConfidencesThatCannotBe) {
    for (const double confidence : tests::kNoProbabilities) {
        EXPECT_THROW((void)wilson(1, 2, confidence), base::Error) << confidence;
    }
    EXPECT_THROW((void)wilson(3, 2), base::Error);
}

/// The chance that Holm's correction of `tests` true nulls with n votes each rejects any: its first
/// step decides.
template <typename PValueOf>
double familywise_error(std::int64_t n, int tests, PValueOf p_of) {
    double size = 0.0;
    for (std::int64_t b = 0; b <= n; ++b) {
        if (p_of(b) * tests >= .05) continue;
        const auto count = static_cast<double>(n);
        const auto chosen = static_cast<double>(b);
        size += std::exp(std::lgamma(count + 1.0) - std::lgamma(chosen + 1.0) -
                         std::lgamma(count - chosen + 1.0) - count * std::numbers::ln2);
    }
    return 1.0 - std::pow(1.0 - size, tests);
}

TEST(Holm, KeepsItsLevelOverExactTestsAndNotOverChiSquare) {
    for (const auto& [n, by_chi_square] :
         {std::pair(11, .079), {31, .072}, {42, .054}, {36, .027}}) {
        const std::int64_t votes = n;
        EXPECT_NEAR(familywise_error(n, 7,
                                     [&](std::int64_t b) {
                                         return chi_square_equal_split({votes - b, b})->p.p;
                                     }),
                    by_chi_square, 5e-4)
            << n;
        EXPECT_LE(
            familywise_error(n, 7, [&](std::int64_t b) { return exact_binomial(b, votes)->p; }),
            .05)
            << n;
    }
}

TEST(Holm, MeetsTheExample) {
    EXPECT_THAT(holm({.01, .04, .03, .005}),  // R: p.adjust(..., "holm")
                ElementsAre(DoubleNear(.03, 1e-12), DoubleNear(.06, 1e-12), DoubleNear(.06, 1e-12),
                            DoubleNear(.02, 1e-12)));
    EXPECT_THAT(holm({}), IsEmpty());
    EXPECT_THAT(holm({.2}), ElementsAre(.2));
    EXPECT_THAT(holm({0.0, 1.0, .9}), ElementsAre(0.0, 1.0, 1.0));
    EXPECT_THAT(holm({.5, .5, .5}), ElementsAre(1.0, 1.0, 1.0));
    for (const double p : tests::kNoProbabilities) EXPECT_THROW((void)holm({.5, p}), base::Error);
}

TEST(ClopperPearson, MeetsPublishedIntervals) {
    EXPECT_EQ(clopper_pearson(0, 36)->low, 0.0);
    EXPECT_NEAR(clopper_pearson(0, 36)->high, .09739376, 1e-8);  // R: binom.test(0, 36)
    EXPECT_EQ(clopper_pearson(36, 36)->high, 1.0);
    EXPECT_NEAR(clopper_pearson(36, 36)->low, 1.0 - .09739376, 1e-8);
    EXPECT_NEAR(clopper_pearson(25, 36)->low, .51892937, 1e-8);  // mpmath 1.3, 25 digits
    EXPECT_NEAR(clopper_pearson(25, 36)->high, .836526015372, 1e-11);
    for (const double confidence : tests::kNoProbabilities) {
        EXPECT_THROW((void)clopper_pearson(1, 2, confidence), base::Error) << confidence;
    }
    EXPECT_THROW((void)clopper_pearson(3, 2), base::Error);
}

TEST(BenjaminiHochberg, MeetsTheExample) {
    EXPECT_THAT(benjamini_hochberg({.01, .04, .03, .005}),  // R: p.adjust(..., "BH")
                ElementsAre(DoubleNear(.02, 1e-12), DoubleNear(.04, 1e-12), DoubleNear(.04, 1e-12),
                            DoubleNear(.02, 1e-12)));
    EXPECT_THAT(benjamini_hochberg({}), IsEmpty());
    EXPECT_THAT(benjamini_hochberg({.2}), ElementsAre(.2));
    EXPECT_THAT(benjamini_hochberg({0.0, 1.0}), ElementsAre(0.0, 1.0));
    for (const double p : tests::kNoProbabilities) {
        EXPECT_THROW((void)benjamini_hochberg({.5, p}), base::Error);
    }
}

TEST(EveryStatistic, HasAProperValueOrAReasonAtTheEdges) {
    for (const Votes& votes : tests::kEdgeVotes) {
        SCOPED_TRACE(std::to_string(votes.a) + ":" + std::to_string(votes.b));
        const auto chi = chi_square_equal_split(votes);
        const auto exact = exact_binomial(votes.b, votes.n());
        const auto uneven = exact_binomial(votes.b, votes.n(), 0.75);
        const auto interval = wilson(votes.b, votes.n());
        const auto wide = clopper_pearson(votes.b, votes.n());
        const auto g = cohens_g(votes);
        if (votes.n() == 0) {
            for (const std::string& reason : {chi.reason, exact.reason, uneven.reason,
                                              interval.reason, wide.reason, g.reason}) {
                EXPECT_EQ(reason, "no votes");
            }
            EXPECT_FALSE(chi.has_value() || exact.has_value() || uneven.has_value() ||
                         interval.has_value() || g.has_value());
            continue;
        }
        EXPECT_TRUE(std::isfinite(chi->statistic) && chi->statistic >= 0.0);
        EXPECT_TRUE(tests::is_proper(chi->p)) << chi->p.p << " " << chi->p.log10_p;
        EXPECT_TRUE(tests::is_proper(*exact)) << exact->p << " " << exact->log10_p;
        EXPECT_TRUE(tests::is_proper(*uneven)) << uneven->p << " " << uneven->log10_p;
        const double share = static_cast<double>(votes.b) / static_cast<double>(votes.n());
        EXPECT_TRUE(0.0 <= interval->low && interval->low <= share && share <= interval->high &&
                    interval->high <= 1.0);
        EXPECT_TRUE(0.0 <= wide->low && wide->low <= share && share <= wide->high &&
                    wide->high <= 1.0)
            << wide->low << " " << wide->high;
        EXPECT_NEAR(*g, share - 0.5, 1e-15);
        if (votes.a == votes.b) {
            EXPECT_EQ(chi->p.p, 1.0);
            EXPECT_EQ(exact->p, 1.0);
            EXPECT_EQ(*g, 0.0);
        }
    }
    for (const Votes& votes : tests::kImpossibleVotes) {
        EXPECT_THROW((void)chi_square_equal_split(votes), base::Error);
        EXPECT_THROW((void)chi_square_homogeneity({{1, 1}, votes}), base::Error);
        EXPECT_THROW((void)cohens_g(votes), base::Error);
    }
}

}  // namespace
}  // namespace obscura::analysis
