// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/statistics/bayes_factor.h"
#include "analysis/statistics/posterior.h"
#include "renderer/base/error.h"
#include "tests/analysis/edge_inputs.h"

namespace obscura::analysis {
namespace {

TEST(FlatPosterior, MeetsTwentyTwoOfThirtySix) {
    // R 4.2.2: qbeta(c(.025, .975), 23, 15), 1 - pbeta(.5, 23, 15).
    const auto posterior = posterior_flat(22, 36);
    EXPECT_NEAR(posterior->mean, .605263, 1e-6);
    EXPECT_NEAR(posterior->interval.low, .447568, 1e-6);
    EXPECT_NEAR(posterior->interval.high, .752458, 1e-6);
    EXPECT_NEAR(posterior->above_half.p, .906129, 1e-6);
    EXPECT_NEAR(posterior_flat(25, 36)->above_half.p, .989963, 1e-6);
    EXPECT_EQ(posterior_flat(18, 36)->mean, 0.5);
    EXPECT_NEAR(posterior_flat(18, 36)->above_half.p, 0.5, 1e-15);
}

TEST(FlatPosterior, TheProbabilityKeepsItsSizeWhereDoublesEnd) {
    // All against: P(share > 1/2) = 2^-(n + 1), the integral of (n + 1) (1 - s)^n.
    EXPECT_NEAR(posterior_flat(0, 36)->above_half.p, 0x1p-37, 1e-25);
    EXPECT_NEAR(posterior_flat(0, 9'999)->above_half.log10_p,
                -10'000 * std::numbers::ln2 / std::numbers::ln10, 1e-9);
}

TEST(BayesFactor, MeetsTwentyFiveOfThirtySix) {
    // R 4.2.2 prints 3.091323; the digits are 2^36 / (37 C(36, 25)) in rational arithmetic.
    EXPECT_NEAR(*bayes_factor(25, 36)->bf10, 3.0913228751349537, 1e-6);
    EXPECT_NEAR(bayes_factor(25, 36)->log10_bf10, std::log10(3.0913228751349537), 1e-6);
    EXPECT_NEAR(*bayes_factor(0, 36)->bf10, 0x1p36 / 37.0, 1e-3);
    EXPECT_NEAR(*bayes_factor(1, 1)->bf10, 1.0, 1e-12) << "one vote says nothing";
}

TEST(BayesFactor, KeepsItsLogarithmWhereDoublesEnd) {
    const auto far = bayes_factor(0, 10'000);
    EXPECT_FALSE(far->bf10.has_value());
    EXPECT_FALSE(far->bf10.reason.empty());
    EXPECT_NEAR(far->log10_bf10, 10'000 * std::log10(2.0) - std::log10(10'001.0), 1e-8);
}

TEST(PosteriorAndBayesFactor, HaveProperValuesOrAReasonAtTheEdges) {
    for (const Votes& votes : tests::kEdgeVotes) {
        SCOPED_TRACE(std::to_string(votes.a) + ":" + std::to_string(votes.b));
        const auto posterior = posterior_flat(votes.b, votes.n());
        const auto factor = bayes_factor(votes.b, votes.n());
        if (votes.n() == 0) {
            EXPECT_EQ(posterior.reason, "no votes");
            EXPECT_EQ(factor.reason, "no votes");
            continue;
        }
        EXPECT_TRUE(0.0 < posterior->mean && posterior->mean < 1.0);
        EXPECT_TRUE(0.0 <= posterior->interval.low && posterior->interval.high <= 1.0 &&
                    posterior->interval.low < posterior->interval.high)
            << posterior->interval.low << " " << posterior->interval.high;
        EXPECT_TRUE(tests::is_proper(posterior->above_half))
            << posterior->above_half.p << " " << posterior->above_half.log10_p;
        EXPECT_TRUE(std::isfinite(factor->log10_bf10));
        if (factor->bf10.has_value()) {
            EXPECT_NEAR(std::log10(*factor->bf10), factor->log10_bf10, 1e-9);
        }
    }
}

TEST(PosteriorAndBayesFactor, RefuseCountsThatCannotBe) {
    EXPECT_THROW((void)posterior_flat(3, 2), base::Error);
    EXPECT_THROW((void)posterior_flat(-1, 2), base::Error);
    EXPECT_THROW((void)bayes_factor(3, 2), base::Error);
    EXPECT_THROW((void)bayes_factor(0, -1), base::Error);
    for (const double confidence : tests::kNoProbabilities) {
        EXPECT_THROW((void)posterior_flat(1, 2, confidence), base::Error);
    }
}

}  // namespace
}  // namespace obscura::analysis
