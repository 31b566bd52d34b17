// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/simulated_observer.h"

#include <gtest/gtest.h>

#include "analysis/published_votes.h"
#include "renderer/base/error.h"
#include "tests/app/kiosk/small_study.h"

namespace obscura::app::kiosk {
namespace {

using analysis::TrialRecord;

/// The trials of one observer.
std::vector<TrialRecord> trials_of(const stimuli::Study& study, const ChoiceModel& choices,
                                   std::uint64_t number, bool swapped) {
    SessionPlan plan = small_plan(study, swapped);
    plan.kind = analysis::Kind::kSimulated;
    Procedure procedure(study, plan);
    std::vector<TrialRecord> trials;
    Journal journal([&trials](const Row& row) {
        if (const auto* trial = std::get_if<TrialRecord>(&row)) trials.push_back(*trial);
    });
    base::Random random(observer_seed(study.seed, number));
    VirtualClock clock;
    simulate_observer(procedure, choices, random, clock, journal);
    return trials;
}

TEST(SimulatedObserver, GivesOneSoundSimulatedRowForEachPairInOrder) {
    const stimuli::Study study = small_study(4);
    const auto trials = trials_of(study, choices_from(study, {}), 1, false);
    ASSERT_EQ(trials.size(), 4U);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(trials[i].kind, analysis::Kind::kSimulated);
        EXPECT_EQ(trials[i].trial_index, i);
        EXPECT_NEAR(trials[i].grey_ms_measured, 2000.0, 1e-6);
        EXPECT_GT(trials[i].first_view_ms, 0.0);
        EXPECT_GT(trials[i].second_view_ms, 0.0);
        EXPECT_GT(trials[i].response_time_s, 0.0);
        EXPECT_EQ(trials[i].answered_utc.substr(0, 10), "2000-01-01");
    }
}

TEST(SimulatedObserver, TheSameSeedAnswersTheSameAndAnotherDoesNot) {
    const stimuli::Study study = small_study(7);
    const ChoiceModel choices = choices_from(study, {});
    const auto once = trials_of(study, choices, 1, false);
    const auto again = trials_of(study, choices, 1, false);
    const auto other = trials_of(study, choices, 2, false);
    EXPECT_EQ(once[0].response_time_s, again[0].response_time_s);
    EXPECT_NE(once[0].response_time_s, other[0].response_time_s);
}

TEST(SimulatedObserver, ChoosesBAsOftenAsItsProbabilitySaysWhicheverIsShownFirst) {
    const stimuli::Study study = small_study(2, 100);
    const ChoiceModel choices{{0.2, 1.0}, {}};
    int b_of_first = 0;
    constexpr int kObservers = 1000;
    for (int number = 0; number < kObservers; ++number) {
        for (const TrialRecord& row : trials_of(study, choices, number, number % 2 == 1)) {
            if (row.condition == "C2") {
                EXPECT_FALSE(row.is_A_selected);
            } else {
                b_of_first += row.is_A_selected ? 0 : 1;
            }
        }
    }
    // Four standard deviations of a binomial with p = 0.2.
    EXPECT_NEAR(b_of_first, 200, 51);
}

TEST(SimulatedObserver, TakesProbabilitiesFromThePublishedVotesOfTheSameVariants) {
    stimuli::Study study = small_study(3);
    const std::vector<std::string> ids{"II", "V", "VII"};
    for (std::size_t i = 0; i < ids.size(); ++i) {
        study.conditions[i].id = ids[i];
        study.conditions[i].b.technique = "blizzard";
        study.conditions[i].b.samples = ids[i] == "VII" ? 8 : 24;
    }
    const ChoiceModel choices = choices_from(study, analysis::published_votes());
    ASSERT_EQ(choices.probability_of_b.size(), 3U);
    EXPECT_DOUBLE_EQ(choices.probability_of_b[0], 22.0 / 36.0);
    EXPECT_DOUBLE_EQ(choices.probability_of_b[1], 25.0 / 36.0);
    EXPECT_DOUBLE_EQ(choices.probability_of_b[2], 0.5);
    EXPECT_EQ(choices.unpublished, std::vector<std::string>{"VII"});
}

TEST(SimulatedObserver, StopsWithTheReasonWhenARowCannotBeSaved) {
    const stimuli::Study study = small_study(2);
    Procedure procedure(study, small_plan(study));
    Journal journal([](const Row&) { throw base::failure("the disk is full"); });
    base::Random random(1);
    VirtualClock clock;
    EXPECT_THROW(simulate_observer(procedure, choices_from(study, {}), random, clock, journal),
                 base::Error);
}

}  // namespace
}  // namespace obscura::app::kiosk
