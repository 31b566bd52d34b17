// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/power.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/exact_binomial.h"
#include "renderer/base/error.h"
#include "tests/analysis/edge_inputs.h"

namespace obscura::analysis {
namespace {

/// By summing over all outcomes with the test's own p-value.
double slow_power(int n, double share, double level) {
    double sum = 0.0;
    for (int k = 0; k <= n; ++k) {
        if (exact_binomial(k, n)->p >= level) continue;
        sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) +
                        k * std::log(share) + (n - k) * std::log1p(-share));
    }
    return sum;
}

TEST(ParticipantsNeeded, MeetTheTableForEightyPercentPower) {
    // Independently computed in R 4.2.2 by sums of dbinom.
    EXPECT_EQ(*participants_needed(SplitTest::kExact, .60, .05, .8), 210);
    EXPECT_EQ(*participants_needed(SplitTest::kExact, .65, .05, .8), 97);
    EXPECT_EQ(*participants_needed(SplitTest::kExact, .70, .05, .8), 54);
    EXPECT_EQ(*participants_needed(SplitTest::kExact, .75, .05, .8), 35);
    EXPECT_EQ(*participants_needed(SplitTest::kExact, .25, .05, .8), 35) << "either side";
}

TEST(ParticipantsNeeded, KeepThePowerForTheNextSixAndNotFromOneEarlier) {
    for (const double share : {.55, .62, .9, .99}) {
        for (const SplitTest test : {SplitTest::kExact, SplitTest::kChiSquare}) {
            const std::int64_t n = *participants_needed(test, share, .05, .8);
            for (std::int64_t next = n; next <= n + kStaysForNext; ++next) {
                EXPECT_GE(power_of(test, next, share, .05).power, .8) << share << " " << next;
            }
            bool earlier_holds = n > 1;
            for (std::int64_t next = n - 1; next > 0 && next < n + kStaysForNext; ++next) {
                earlier_holds &= power_of(test, next, share, .05).power >= .8;
            }
            EXPECT_FALSE(earlier_holds) << share;
        }
    }
}

TEST(ParticipantsNeeded, AreThoseThatASearchFromOneFinds) {
    for (const double share : {.55, .42, .7}) {
        for (const double power : {.03, .3, .8, .99}) {
            for (const double level : {.05, .001, .4}) {
                std::int64_t first = 1;
                for (std::int64_t n = 1; n - first <= kStaysForNext; ++n) {
                    if (power_of(SplitTest::kExact, n, share, level).power < power) first = n + 1;
                }
                EXPECT_EQ(*participants_needed(SplitTest::kExact, share, level, power), first)
                    << share << " " << power << " " << level;
            }
        }
    }
}

TEST(ParticipantsNeeded, IsFoundForSmallEffectsAndUnusualPowers) {
    // The normal approximation (1.959964 + .841621)^2 / (4 * .003^2) is 218,024.
    EXPECT_NEAR(static_cast<double>(*participants_needed(SplitTest::kExact, .503, .05, .8)),
                218024.0, 800.0);
    EXPECT_LT(*participants_needed(SplitTest::kExact, .6, .05, .2), 60);
    EXPECT_GT(*participants_needed(SplitTest::kExact, .6, .05, .999), 400);
    EXPECT_GT(*participants_needed(SplitTest::kExact, .65, .05 / 7, .8), 97) << "corrected";
}

TEST(Power, MeetsThirtySixParticipants) {
    // R 4.2.2: the thesis's number of participants and its largest share.
    const TestPower exact = power_of(SplitTest::kExact, 36, 25.0 / 36.0, .05);
    EXPECT_NEAR(exact.power, .580595, 1e-6);
    EXPECT_EQ(*exact.critical_votes, 25);
    const TestPower chi_square = power_of(SplitTest::kChiSquare, 36, 25.0 / 36.0, .05);
    EXPECT_NEAR(chi_square.power, .711784, 1e-6);
    EXPECT_NEAR(chi_square.true_size, .065245, 1e-6);
    EXPECT_EQ(*chi_square.critical_votes, 24);
}

TEST(Power, EqualsTheSumOverAllOutcomes) {
    for (const int n : {1, 5, 6, 7, 36, 101}) {
        for (const double share : {.3, .5, .65}) {
            for (const double level : {.05, .01, .5}) {
                EXPECT_NEAR(power_of(SplitTest::kExact, n, share, level).power,
                            slow_power(n, share, level), 1e-12)
                    << n << " " << share << " " << level;
            }
        }
    }
}

TEST(Power, TheExactTestNeverExceedsItsLevel) {
    for (std::int64_t n = 1; n < 200; ++n) {
        EXPECT_LT(power_of(SplitTest::kExact, n, .7, .05).true_size, .05) << n;
    }
}

TEST(Power, SaysThatNothingCanBeSignificant) {
    const TestPower power = power_of(SplitTest::kExact, 5, .9, .05);
    EXPECT_FALSE(power.critical_votes.has_value());
    EXPECT_FALSE(power.critical_votes.reason.empty());
    EXPECT_EQ(power.power, 0.0);
    EXPECT_EQ(*power_of(SplitTest::kExact, 6, .9, .05).critical_votes, 6);
    EXPECT_NEAR(power_of(SplitTest::kExact, kMostParticipants, .501, .05).power, 1.0, 1e-12);
}

TEST(Power, RefusesWhatCannotBe) {
    for (const double value : tests::kNoProbabilities) {
        EXPECT_THROW((void)power_of(SplitTest::kExact, 36, value, .05), base::Error);
        EXPECT_THROW((void)power_of(SplitTest::kExact, 36, .6, value), base::Error);
        EXPECT_THROW((void)participants_needed(SplitTest::kExact, .6, .05, value), base::Error);
    }
    EXPECT_THROW((void)power_of(SplitTest::kExact, 0, .6, .05), base::Error);
    EXPECT_THROW((void)power_of(SplitTest::kExact, kMostParticipants + 1, .6, .05), base::Error);
    EXPECT_THROW((void)participants_needed(SplitTest::kExact, .5, .05, .8), base::Error);
    EXPECT_THROW((void)participants_needed(SplitTest::kExact, .5004, .05, .8), base::Error);
}

}  // namespace
}  // namespace obscura::analysis
