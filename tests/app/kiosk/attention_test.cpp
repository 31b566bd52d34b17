// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// A session over a study with attention checks and repeats, through the procedure into the store.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "analysis/store/store.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "renderer/base/error.h"
#include "stimuli/study_reader.h"
#include "tests/app/kiosk/small_study.h"
#include "tests/stimuli/attentive_study.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Kind;
using analysis::SessionState;
using analysis::TrialRecord;

class AttentionInSession : public testing::Test {
  protected:
    [[nodiscard]] SessionPlan plan(int number) const {
        SessionPlan plan = small_plan(study_);
        plan.participant_id = fmt::format("p-{}", number);
        plan.session_id = fmt::format("s-{}", number);
        plan.kind = Kind::kSimulated;
        plan.order = study_.session_order(static_cast<std::uint64_t>(number));
        return plan;
    }
    void observe(int number) {
        Procedure procedure(study_, plan(number));
        Journal journal = journal_to(store_);
        base::Random random(observer_seed(study_.seed, static_cast<std::uint64_t>(number)));
        VirtualClock clock;
        simulate_observer(procedure, choices_from(study_, {}), random, clock, journal);
    }

    stimuli::Study study_ =
        stimuli::read_study(stimuli::attentive_text(), stimuli::test_catalogue()).study;
    tests::TemporaryFolder folder_;
    analysis::Store store_{"sqlite3://" + (folder_ / "responses.sqlite").string(),
                           analysis::Store::Access::kReadWrite};
};

TEST_F(AttentionInSession, EachTrialIsRecordedAsWhatItIsAndAllCountTowardsTheEnd) {
    observe(0);
    const auto session = store_.sessions().at(0);
    EXPECT_EQ(session.condition_count, 4);
    EXPECT_EQ(session.state, SessionState::kCompleted);
    EXPECT_EQ(session.exclusion, study_.exclusion.to_json());
    std::map<std::string, TrialRecord> trials;
    for (const TrialRecord& trial : store_.trials()) trials[trial.condition] = trial;
    ASSERT_EQ(trials.size(), 4U);
    EXPECT_EQ(trials["one"].kind, Kind::kSimulated);
    EXPECT_EQ(trials["one"].expected, '\0');
    EXPECT_EQ(trials["check"].kind, Kind::kCatch);
    EXPECT_EQ(trials["check"].expected, 'B');
    EXPECT_EQ(trials["one-again"].kind, Kind::kSimulated);
    EXPECT_EQ(trials["one-again"].repeats, "one");
    EXPECT_EQ(trials["one-again"].condition_B, trials["one"].condition_B);
}

TEST_F(AttentionInSession, SidesOfATrialAreShownAndRecordedAsTheOrderHasThem) {
    study_.sides = stimuli::SideOrder::kTrial;
    observe(0);
    const auto order = study_.session_order(0);
    const SessionPlan shown = plan(0);
    const auto trials = store_.trials();
    ASSERT_EQ(trials.size(), 4U);
    int b_first = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        EXPECT_EQ(trials[i].first_shown, order.b_first(i) ? 'B' : 'A');
        const auto& images = shown.images.at(static_cast<std::size_t>(order.conditions[i]));
        EXPECT_EQ(trials[i].first_sha256, images[order.b_first(i) ? 1 : 0].sha256);
        if (order.b_first(i)) ++b_first;
    }
    EXPECT_EQ(b_first, 2);
    EXPECT_EQ(store_.sessions().at(0).study_plan, R"({"sides":"trial"})");
}

TEST_F(AttentionInSession, ASessionCutOffAnywhereGoesOnAtItsFirstUnansweredPair) {
    for (int answered = 0; answered < 4; ++answered) {
        // Another observer's answers stand in for those given before the cut.
        observe(2 * answered);
        const SessionPlan whole = plan(2 * answered);
        std::vector<TrialRecord> trials = store_.trials_of(whole.session_id);
        trials.resize(static_cast<std::size_t>(answered));
        SessionPlan cut = plan(2 * answered + 1);
        cut.order = whole.order;
        cut.order.slot = static_cast<std::uint64_t>(2 * answered + 1);
        Procedure first(study_, cut);
        const auto at = [](double time_s) { return Moment{time_s, "2026-05-01T12:00:00Z"}; };
        (void)first.step(ScreenPresented{}, at(0.0));
        (void)first.step(StartPressed{}, at(1.0));
        (void)first.step(ScreenPresented{}, at(2.0));
        for (const Row& row :
             first.step(FormSubmitted{{{}, 30, "", std::nullopt, std::nullopt, true}}, at(3.0))) {
            commit(store_, row);
        }
        for (TrialRecord& trial : trials) {
            trial.session_id = cut.session_id;
            store_.add_trial(trial);
        }
        Procedure rest(study_, cut);
        Journal journal = journal_to(store_);
        journal.add(rest.resume(store_.trials_of(cut.session_id), true, 100.0, at(0.0)));
        EXPECT_EQ(rest.pair(), answered);
        base::Random random(1);
        VirtualClock clock;
        simulate_observer(rest, choices_from(study_, {}), random, clock, journal);
        EXPECT_EQ(store_.trials_of(cut.session_id).size(), 4U);
        EXPECT_EQ(store_.sessions().back().state, SessionState::kCompleted);
    }
}

TEST_F(AttentionInSession, SimulatedObserversMostlyPassAndOftenAnswerAlike) {
    constexpr int kObservers = 300;
    int passed = 0;
    int alike = 0;
    const ChoiceModel choices = choices_from(study_, {});
    EXPECT_EQ(choices.unpublished, (std::vector<std::string>{"one", "two"}));
    for (int number = 0; number < kObservers; ++number) {
        std::map<std::string, TrialRecord> trials;
        Journal journal([&](const Row& row) {
            if (const auto* trial = std::get_if<TrialRecord>(&row)) {
                trials[trial->condition] = *trial;
            }
        });
        Procedure procedure(study_, plan(number));
        base::Random random(observer_seed(study_.seed, static_cast<std::uint64_t>(number)));
        VirtualClock clock;
        simulate_observer(procedure, choices, random, clock, journal);
        passed += trials["check"].is_A_selected ? 0 : 1;
        alike += trials["one"].is_A_selected == trials["one-again"].is_A_selected ? 1 : 0;
    }
    // 95 % and 80 %, give or take four standard deviations of a binomial.
    EXPECT_NEAR(passed, 285, 16);
    EXPECT_NEAR(alike, 240, 28);
}

}  // namespace
}  // namespace obscura::app::kiosk
