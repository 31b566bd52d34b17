// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Practice, breaks, and the ways of showing a pair that are not the thesis's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/store/store.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "renderer/base/error.h"
#include "tests/app/kiosk/script.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Kind;
using analysis::TrialRecord;
using testing::ElementsAre;

/// `count` pairs that count, and two of practice of which the first has an expected side.
stimuli::Study practising_study(int count) {
    stimuli::Study study = small_study(count + 2);
    for (int i = count; i < count + 2; ++i) {
        study.conditions[static_cast<std::size_t>(i)].practice = true;
        study.conditions[static_cast<std::size_t>(i)].hypothesis = "";
    }
    study.conditions[static_cast<std::size_t>(count)].expected = 'B';
    return study;
}

TEST(Practice, ComesFirstWithItsFeedbackAndEndsOnAPageOfItsOwn) {
    const stimuli::Study study = practising_study(2);
    Script script(study);
    script.reach_pairs();
    EXPECT_TRUE(script.procedure.progress().practice);
    EXPECT_EQ(script.procedure.progress().count, 2);
    script.answer_pair(20, 0, false);
    EXPECT_EQ(script.procedure.screen(), Screen::kFeedback);
    EXPECT_TRUE(script.procedure.was_expected());
    script.at(34, WentOn{});
    script.shown_at(35);
    EXPECT_EQ(script.procedure.screen(), Screen::kPairs);
    script.answer_pair(40, 1, false);
    EXPECT_EQ(script.procedure.screen(), Screen::kPracticeOver);
    script.at(54, PairPressed{0});
    EXPECT_EQ(script.procedure.screen(), Screen::kPracticeOver);
    script.at(55, WentOn{});
    script.shown_at(56);
    EXPECT_FALSE(script.procedure.progress().practice);
    EXPECT_EQ(script.procedure.progress().pair, 0);
    script.answer_pair(60, 0, true);
    script.answer_pair(80, 1, true);
    EXPECT_EQ(script.procedure.screen(), Screen::kThanks);
}

TEST(Practice, TheOtherAnswerIsToldFromTheExpectedOneOnEitherSide) {
    const stimuli::Study study = practising_study(2);
    for (const bool swapped : {false, true}) {
        for (const bool first : {false, true}) {
            Script script(study, swapped);
            script.reach_pairs();
            script.answer_pair(20, 0, first);
            EXPECT_EQ(script.procedure.was_expected(), first == swapped);
        }
    }
}

TEST(Practice, IsStoredAsPracticeAndCompletesNoSession) {
    const stimuli::Study study = practising_study(2);
    tests::TemporaryFolder folder;
    analysis::Store store("sqlite3://" + (folder / "a.sqlite").string(),
                          analysis::Store::Access::kReadWrite);
    Procedure procedure(study, small_plan(study));
    Journal journal = journal_to(store);
    base::Random random(3);
    VirtualClock clock;
    simulate_observer(procedure, choices_from(study, {}), random, clock, journal);
    std::vector<Kind> kinds;
    std::vector<std::string> conditions;
    for (const TrialRecord& trial : store.trials()) {
        kinds.push_back(trial.kind);
        conditions.push_back(trial.condition);
        EXPECT_EQ(trial.expected, '\0');
    }
    EXPECT_THAT(kinds, ElementsAre(Kind::kPractice, Kind::kPractice, Kind::kParticipant,
                                   Kind::kParticipant));
    EXPECT_THAT(conditions, ElementsAre("C3", "C4", "C2", "C1"));
    EXPECT_EQ(store.sessions().at(0).condition_count, 2);
    EXPECT_EQ(store.sessions().at(0).state, analysis::SessionState::kCompleted);
}

TEST(Practice, ASessionCutOffInItGoesOnInIt) {
    const stimuli::Study study = practising_study(2);
    Script whole(study);
    whole.reach_pairs();
    whole.answer_pair(20, 0, true);
    Procedure rest(study, small_plan(study));
    (void)rest.resume(whole.rows_of<TrialRecord>(), true, 100.0, {0.0, "t", 0.0});
    EXPECT_EQ(rest.screen(), Screen::kPairs);
    EXPECT_TRUE(rest.progress().practice);
    EXPECT_EQ(rest.progress().pair, 1);
}

TEST(Breaks, ComeAfterThatManyPairsAndCannotBeLeftEarly) {
    stimuli::Study study = small_study(4);
    study.presentation.break_after = 2;
    study.presentation.break_min_s = 30;
    Script script(study);
    script.reach_pairs();
    script.answer_pair(20, 0, true);
    EXPECT_EQ(script.procedure.screen(), Screen::kPairs);
    script.answer_pair(40, 1, true);  // the break is visible at 53
    EXPECT_EQ(script.procedure.screen(), Screen::kBreak);
    script.at(82.9, WentOn{});
    EXPECT_EQ(script.procedure.screen(), Screen::kBreak);
    script.at(84.5, WentOn{});
    EXPECT_EQ(script.procedure.screen(), Screen::kPairs);
    const auto events = script.rows_of<analysis::EventRecord>();
    EXPECT_EQ(events.back().name, "break");
    EXPECT_EQ(events.back().detail, "31.5 s, after 2 pairs");
    script.shown_at(85);
    script.answer_pair(90, 2, true);
    script.answer_pair(110, 3, true);
    EXPECT_EQ(script.procedure.screen(), Screen::kThanks) << "no break after the last";
}

TEST(Presentation, AnImageOrAQuestionTakesNothingBeforeItsTime) {
    stimuli::Study study = small_study(2);
    study.presentation.min_view_ms = 2000;
    study.presentation.min_response_ms = 1000;
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(22.9, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    // The operator's question is no time of looking, and what was seen before it is.
    script.at(22.9, LeaveRequested{});
    script.shown_at(24);
    script.at(30, LeaveCancelled{});
    script.shown_at(31);
    script.at(31.05, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage) << "the input's delay";
    script.at(31.4, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval);
    script.shown_at(32);
    script.at(34, Tick{34});
    script.shown_at(34);
    script.at(37, SpacePressed{});
    script.shown_at(38);
    script.at(38.9, Answered{true});
    EXPECT_EQ(script.procedure.screen(), Screen::kQuestion);
    script.at(39.1, Answered{true});
    EXPECT_EQ(script.procedure.screen(), Screen::kPairs);
}

TEST(Presentation, ATimedImageGoesByItselfAndItsTimeIsWhatWasSeen) {
    stimuli::Study study = small_study(2);
    study.presentation.exposure_ms = 500;
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(21.4, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage) << "no key ends it";
    EXPECT_EQ(script.procedure.next_due_s(), 21.5);
    script.at(21.45, Tick{21.49});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    script.at(21.49, Tick{21.5});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval);
    script.shown_at(21.52);
    script.at(23.52, Tick{23.52});
    script.shown_at(23.53);
    script.at(24.03, Tick{24.03});
    EXPECT_EQ(script.procedure.screen(), Screen::kQuestion);
    script.shown_at(24.05);
    script.at(25, Answered{true});
    const TrialRecord row = script.rows_of<TrialRecord>().at(0);
    EXPECT_NEAR(row.first_view_ms, 520.0, 1e-6);
    EXPECT_NEAR(row.second_view_ms, 520.0, 1e-6);
    EXPECT_NEAR(row.grey_ms_measured, 2010.0, 1e-6);
}

TEST(Presentation, ATimedImageThatWasCoveredIsShownForTheRest) {
    stimuli::Study study = small_study(2);
    study.presentation.exposure_ms = 500;
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(21.3, ScreenHidden{"covered"});
    EXPECT_EQ(script.procedure.next_due_s(), std::nullopt);
    script.at(25, ScreenSeen{});
    script.shown_at(25.1);
    EXPECT_NEAR(script.procedure.next_due_s().value(), 25.3, 1e-9);
    script.at(25.3, Tick{25.3});
    // Gone again before the next screen was visible: nobody saw the image meanwhile.
    script.at(25.31, ScreenHidden{"covered"});
    script.at(26, ScreenSeen{});
    script.shown_at(27);
    script.at(29, Tick{29});
    script.shown_at(29);
    script.at(29.5, Tick{29.5});
    script.shown_at(29.5);
    script.at(31, Answered{true});
    EXPECT_NEAR(script.rows_of<TrialRecord>().at(0).first_view_ms, 500.0, 1e-6);
}

TEST(Presentation, SideBySideBothImagesHaveOneOnsetAndNoInterval) {
    stimuli::Study study = small_study(2);
    study.presentation.layout = stimuli::Layout::kSideBySide;
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    EXPECT_EQ(script.procedure.screen(), Screen::kBothImages);
    script.at(24, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kQuestion);
    script.shown_at(24.1);
    script.at(26.1, Answered{false});
    const TrialRecord row = script.rows_of<TrialRecord>().at(0);
    EXPECT_EQ(row.first_onset_s, row.second_onset_s);
    EXPECT_EQ(row.grey_ms_measured, 0.0);
    EXPECT_NEAR(row.first_view_ms, 3000.0, 1e-6);
    EXPECT_NEAR(row.second_view_ms, 3000.0, 1e-6);
    EXPECT_NEAR(row.response_time_s, 2.0, 1e-9);
    EXPECT_FALSE(row.response_first);
}

}  // namespace
}  // namespace obscura::app::kiosk
