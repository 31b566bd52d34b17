// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "tests/support/calibrated.h"

namespace obscura::analysis {
namespace {

using tests::mantel_haenszel;
using tests::People;
using tests::Rates;

constexpr int kSeededStudies = 60;

/// How far a share of so many may lie from what it is by chance.
double chance(double share, double n) { return 3.3 * std::sqrt(share * (1.0 - share) / n); }
double at_most(double share, double n = kSeededStudies) { return share + chance(share, n); }
double at_least(double share, double n = kSeededStudies) { return share - chance(share, n); }

Rates rates_of(const People& people, std::uint64_t seed = 7) {
    Rates rates;
    tests::count_studies(people, 36, kSeededStudies, seed, false, rates);
    return rates;
}

constexpr const char* kTests[]{"H1, sign flip", "H3, McNemar", "sign flip of d",
                               "any verdict of the family"};
constexpr const char* kIntervals[]{"H1, interval",  "H1, credible interval", "H3, interval",
                                   "interval of d", "JOD, interval",         "order, interval"};

/// The long form, with ten thousand studies, is tests/bench/calibration_bench.
TEST(Calibration, NoTestRejectsTooOftenAndEveryIntervalHoldsWhatItShould) {
    const std::vector<People> nulls = tests::nobody_prefers();
    std::map<std::string, double> sums;
    for (std::size_t i = 0; i < nulls.size(); ++i) {
        const People& people = nulls[i];
        SCOPED_TRACE(people.name);
        const Rates rates = rates_of(people, 100 + i);
        for (const char* name : kTests) {
            EXPECT_LE(rates.of(name), at_most(.05)) << name;
            sums[name] += rates.of(name);
        }
        for (const char* name : kIntervals) {
            EXPECT_GE(rates.of(name), at_least(.95)) << name;
            sums[name] += rates.of(name);
        }
        if (people.pull == 0.0 && people.careless == 0.0) {
            EXPECT_LE(rates.of("order"), at_most(.05));
        } else {
            EXPECT_GT(rates.of("order"), .2) << "which is there";
        }
    }
    const auto all = static_cast<double>(nulls.size());
    for (const char* name : kTests) {
        EXPECT_LE(sums[name] / all, at_most(.05, all * kSeededStudies)) << name;
        EXPECT_GT(sums[name], 0.0) << name;
    }
    for (const char* name : kIntervals) {
        EXPECT_GE(sums[name] / all, at_least(.93, all * kSeededStudies)) << name;
        EXPECT_LE(sums[name] / all, at_most(.97, all * kSeededStudies)) << name;
    }
}

TEST(Calibration, ScenesThatDifferAreNoEffectOfValidity) {
    const Rates rates = rates_of(tests::scenes_differ());
    EXPECT_LE(rates.of("H3, McNemar"), at_most(.05));
    EXPECT_GE(rates.of("H3, interval"), at_least(.95));
    EXPECT_GE(rates.of("H1, interval"), at_least(.95));
    EXPECT_GT(rates.of("conditions differ, Q"), .1) << "which they do";
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
