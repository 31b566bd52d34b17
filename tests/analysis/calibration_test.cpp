// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/calibrated.h"

namespace obscura::analysis {
namespace {

using tests::mantel_haenszel;
using tests::People;
using tests::Rates;

constexpr int kStudies = 60;

/// The largest rate that `share` may show by chance in so many studies.
double at_most(double share) { return share + 3.3 * std::sqrt(share * (1.0 - share) / kStudies); }
double at_least(double share) { return share - 3.3 * std::sqrt(share * (1.0 - share) / kStudies); }

Rates rates_of(const People& people) {
    Rates rates;
    tests::count_studies(people, 36, kStudies, 7, false, rates);
    return rates;
}

/// The long form, with ten thousand studies, is tests/bench/calibration_bench.
TEST(Calibration, NoTestRejectsTooOftenAndEveryIntervalHoldsWhatItShould) {
    for (const People& people : tests::nobody_prefers()) {
        SCOPED_TRACE(people.name);
        const Rates rates = rates_of(people);
        const bool is_level = people.level_sd > 0.0;
        for (const char* name :
             {"H1, sign flip", "H3, McNemar", "sign flip of d", "any verdict of the family"}) {
            EXPECT_LE(rates.of(name), at_most(.05)) << name;
        }
        for (const char* name :
             {"H1, interval", "H3, interval", "interval of d", "JOD, interval"}) {
            EXPECT_GE(rates.of(name), at_least(.95)) << name;
        }
        // Where levels differ for each person, one correlation is not all there is.
        EXPECT_GE(rates.of("H1, credible interval"), at_least(is_level ? .93 : .95));
        if (people.pull == 0.0 && people.careless == 0.0) {
            EXPECT_LE(rates.of("order"), at_most(.05));
            EXPECT_GE(rates.of("order, interval"), at_least(.95));
        } else {
            EXPECT_GT(rates.of("order"), .2) << "which is there";
        }
    }
}

TEST(Calibration, ScenesThatDifferAreNoEffectOfValidity) {
    const Rates rates = rates_of(tests::scenes_differ());
    EXPECT_LE(rates.of("H3, McNemar"), at_most(.05));
    EXPECT_GE(rates.of("H3, interval"), at_least(.95));
    EXPECT_GT(rates.of("counts as independent"), .06) << "which is why they are not pooled";
}

TEST(Calibration, CountingVotesIsWhatDoesNotKeepItsLevel) {
    const Rates rates = rates_of({.name = "b2", .sd = 2.0});
    EXPECT_GT(rates.of("order, counts"), .15);
}

TEST(MantelHaenszel, MeetsRsExamples) {
    // datasets::UCBAdmissions, admitted and rejected by gender in six departments.
    const auto berkeley = mantel_haenszel({{512, 89, 313, 19},
                                           {353, 17, 207, 8},
                                           {120, 202, 205, 391},
                                           {138, 131, 279, 244},
                                           {53, 94, 138, 299},
                                           {22, 24, 351, 317}},
                                          false);
    EXPECT_NEAR(berkeley.corrected, 1.426946, 5e-7);
    EXPECT_NEAR(berkeley.p_corrected, .232264, 1e-6);
    EXPECT_NEAR(berkeley.p_uncorrected, .216924, 5e-7);
    EXPECT_NEAR(berkeley.odds_ratio, .904697, 5e-7);
    // Penicillin in rabbits (Mantel 1963), of R's help page.
    const auto rabbits = mantel_haenszel(
        {{0, 6, 0, 5}, {3, 3, 0, 6}, {6, 0, 2, 4}, {5, 1, 6, 0}, {2, 0, 5, 0}}, true);
    EXPECT_NEAR(rabbits.corrected, 3.928571, 5e-7);
    EXPECT_NEAR(rabbits.p_corrected, .047472, 5e-7);
    EXPECT_EQ(rabbits.sum, 16.0);
    EXPECT_NEAR(rabbits.p_exact, .039945, 5e-7);
}

}  // namespace
}  // namespace obscura::analysis
