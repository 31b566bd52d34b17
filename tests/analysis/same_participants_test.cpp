// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/statistics/cochran_q.h"
#include "analysis/statistics/fisher_exact.h"
#include "analysis/statistics/mcnemar.h"
#include "renderer/base/error.h"
#include "tests/analysis/edge_inputs.h"

namespace obscura::analysis {
namespace {

using VoteRows = std::vector<std::vector<bool>>;

TEST(CochranQ, MeetsTheExampleOfNineParticipants) {
    // Q = 4.2, df 3, p .240662 (R 4.2.2, from Cochran 1950's formula).
    const auto q = cochran_q(VoteRows{{1, 0, 1, 1},
                                      {0, 1, 1, 1},
                                      {1, 1, 1, 0},
                                      {0, 1, 0, 0},
                                      {0, 1, 0, 0},
                                      {1, 0, 1, 0},
                                      {0, 1, 0, 0},
                                      {1, 1, 1, 1},
                                      {0, 1, 0, 0}});
    EXPECT_NEAR(q->statistic, 4.2, 1e-12);
    EXPECT_EQ(q->df, 3);
    EXPECT_NEAR(q->p.p, .240662, 1e-6);
}

TEST(CochranQ, OfTwoConditionsIsMcNemarsStatistic) {
    const auto q = cochran_q(VoteRows{{1, 0}, {1, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 0}});
    EXPECT_NEAR(q->statistic, mcnemar({1, 3})->uncorrected.statistic, 1e-12);
}

TEST(CochranQ, SaysWhyItHasNoValue) {
    EXPECT_EQ(cochran_q({}).reason, "no participants");
    EXPECT_EQ(cochran_q(VoteRows{{true}, {false}}).reason, "fewer than two conditions");
    EXPECT_EQ(cochran_q(VoteRows{{1, 1, 1}, {0, 0, 0}}).reason,
              "every participant answered alike under all conditions");
    EXPECT_THROW((void)cochran_q(VoteRows{{1, 0}, {1, 0, 1}}), base::Error);
}

TEST(McNemar, MeetsTheApprovalRatings) {
    // Agresti 1990, p. 350; R: mcnemar.test(matrix(c(794, 86, 150, 570), 2)) and correct = FALSE.
    const auto test = mcnemar({150, 86});
    EXPECT_EQ(test->discordant, 236);
    EXPECT_NEAR(test->uncorrected.statistic, 17.3559, 5e-5);
    EXPECT_NEAR(test->corrected.statistic, 16.818, 5e-4);
    EXPECT_NEAR(test->corrected.p.p, 4.115e-5, 5e-9);  // as R's example prints it
    // R: 2 * pbinom(86, 236, 1 / 2)
    EXPECT_NEAR(test->exact.p, 3.715936e-5, 5e-12);
}

TEST(McNemar, KeepsItsLevelExactAndNotByChiSquare) {
    double by_chi_square = 0.0;
    double exact = 0.0;
    for (int b = 0; b <= 26; ++b) {
        const double chance = std::exp(std::lgamma(27.0) - std::lgamma(b + 1.0) -
                                       std::lgamma(27.0 - b) - 26.0 * std::log(2.0));
        const auto test = mcnemar({26 - b, b});
        if (test->uncorrected.p.p < .05) by_chi_square += chance;
        if (test->exact.p < .05) exact += chance;
    }
    EXPECT_NEAR(by_chi_square, .076, 5e-4);
    EXPECT_LE(exact, .05);
}

TEST(McNemar, IsExactWhateverTheNumberOfChangedAnswers) {
    const auto test = mcnemar({1, 7});
    EXPECT_NEAR(test->exact.p, 18.0 / 256.0, 1e-15);  // 2 (1 + 8) / 2^8
    // 8 to 18 of 26: chi-square 3.846, p .0499, is significant where the exact test is not.
    const auto many = mcnemar({8, 18});
    EXPECT_LT(many->uncorrected.p.p, .05);
    EXPECT_NEAR(many->exact.p, .0755187, 5e-8);
    EXPECT_EQ(mcnemar({12, 13})->corrected.statistic, 0.0);
    EXPECT_EQ(mcnemar({5, 5})->corrected.p.p, 1.0);
}

TEST(FisherExact, MeetsPublishedAndExactValues) {
    // R 4.2.2: fisher.test; Jakobsen 2010, atrium at moderate against high validity.
    EXPECT_NEAR(fisher_exact({11, 25}, {18, 18})->p, .148839, 1e-6);
    // Fisher 1962, convictions of twins of criminals; R's example of fisher.test prints 0.0005367.
    EXPECT_NEAR(fisher_exact({15, 2}, {3, 10})->p, .0005367, 5e-8);
    EXPECT_NEAR(fisher_exact({3, 1}, {1, 3})->p, 34.0 / 70.0, 1e-14);  // the lady tasting tea
    // Rational arithmetic over all tables with these sums.
    EXPECT_NEAR(fisher_exact({300, 200}, {250, 260})->p, .000508175750989948, 1e-13);
}

TEST(FisherExact, IsTheSameWhicheverWayTheTableIsTurned) {
    const double p = fisher_exact({14, 22}, {11, 25})->p;
    EXPECT_NEAR(fisher_exact({11, 25}, {14, 22})->p, p, 1e-13);
    EXPECT_NEAR(fisher_exact({22, 14}, {25, 11})->p, p, 1e-13);
    EXPECT_NEAR(fisher_exact({14, 11}, {22, 25})->p, p, 1e-13);
}

TEST(FisherExact, TheTailKeepsItsSizeWhereDoublesEnd) {
    // Everything apart: 2 / C(2 n, n) for two rows of n, by Stirling's series.
    const double n = 1e6;
    const double log10_choose =
        (2.0 * n * std::log(2.0) - 0.5 * std::log(std::numbers::pi * n) - 1.0 / (8.0 * n)) /
        std::log(10.0);
    const auto apart = fisher_exact({0, 1'000'000}, {1'000'000, 0});
    EXPECT_NEAR(apart->log10_p, std::log10(2.0) - log10_choose, 1e-6);
    EXPECT_EQ(apart->p, 0.0);
}

TEST(SameParticipantsTests, HaveProperValuesOrAReasonAtTheEdges) {
    for (const Votes& one : tests::kEdgeVotes) {
        const auto changed = mcnemar(one);
        if (one.n() == 0) {
            EXPECT_EQ(changed.reason, "no participant changed the answer");
        } else {
            EXPECT_TRUE(tests::is_proper(changed->uncorrected.p));
            EXPECT_TRUE(tests::is_proper(changed->corrected.p));
            EXPECT_TRUE(tests::is_proper(changed->exact));
        }
        for (const Votes& other : tests::kEdgeVotes) {
            SCOPED_TRACE(std::to_string(one.a) + ":" + std::to_string(one.b) + " and " +
                         std::to_string(other.a) + ":" + std::to_string(other.b));
            const auto p = fisher_exact(one, other);
            if (p.has_value()) {
                EXPECT_TRUE(tests::is_proper(*p)) << p->p << " " << p->log10_p;
            } else {
                EXPECT_FALSE(p.reason.empty());
            }
        }
    }
    for (const Votes& votes : tests::kImpossibleVotes) {
        EXPECT_THROW((void)mcnemar(votes), base::Error);
        EXPECT_THROW((void)fisher_exact({1, 1}, votes), base::Error);
    }
}

}  // namespace
}  // namespace obscura::analysis
