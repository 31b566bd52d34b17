// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/procedure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/base/error.h"
#include "tests/app/kiosk/script.h"

namespace obscura::app::kiosk {
namespace {

using analysis::EventRecord;
using analysis::TrialRecord;

TEST(Procedure, GoesThroughTheThesisScreensAndGivesOneRowForEachAnswer) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    EXPECT_EQ(script.procedure.screen(), Screen::kPairs);
    script.answer_pair(20, 0, true);
    script.answer_pair(40, 1, false);
    EXPECT_EQ(script.procedure.screen(), Screen::kThanks);
    script.at(60, NextParticipant{});
    EXPECT_EQ(script.procedure.screen(), Screen::kDone);

    const auto trials = script.rows_of<TrialRecord>();
    ASSERT_EQ(trials.size(), 2U);
    EXPECT_EQ(trials[0].condition, "C2");
    EXPECT_EQ(trials[1].condition, "C1");
    EXPECT_EQ(trials[1].trial_index, 1);
    const auto complete = script.rows_of<CompleteSession>();
    ASSERT_EQ(complete.size(), 1U);
    EXPECT_EQ(complete[0].ended_utc, "t52.5");
    EXPECT_TRUE(std::holds_alternative<CompleteSession>(script.rows.back()));
}

TEST(Procedure, ATrialRowHoldsEverythingThatWasShownAndWhen) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.answer_pair(20, 0, true);
    const TrialRecord row = script.rows_of<TrialRecord>().at(0);
    EXPECT_EQ(row.session_id, "s-1");
    EXPECT_EQ(row.kind, analysis::Kind::kParticipant);
    EXPECT_EQ(row.trial_index, 0);
    EXPECT_EQ(row.hypothesis, "H1");
    EXPECT_EQ(row.scene, "court");
    EXPECT_EQ(row.validity, "high");
    EXPECT_EQ(row.condition_A, study.conditions[1].a.variant_name());
    EXPECT_EQ(row.condition_B, study.conditions[1].b.variant_name());
    EXPECT_EQ(row.first_shown, 'A');
    EXPECT_TRUE(row.response_first);
    EXPECT_TRUE(row.is_A_selected);
    EXPECT_DOUBLE_EQ(row.first_onset_s, 17.0);
    EXPECT_DOUBLE_EQ(row.second_onset_s, 22.02);
    EXPECT_DOUBLE_EQ(row.question_onset_s, 27.0);
    EXPECT_DOUBLE_EQ(row.response_time_s, 1.5);
    EXPECT_NEAR(row.first_view_ms, 3000.0, 1e-9);
    EXPECT_NEAR(row.second_view_ms, 4000.0, 1e-9);
    EXPECT_NEAR(row.grey_ms_measured, 2010.0, 1e-9);
    EXPECT_EQ(row.first_sha256.substr(0, 4), "a2a2");
    EXPECT_EQ(row.second_sha256.substr(0, 4), "b2b2");
    EXPECT_EQ(row.answered_utc, "t32.5");
}

TEST(Procedure, SwappedShowsBFirstAndTheAnswerStillNamesTheRightSide) {
    const stimuli::Study study = small_study(2);
    Script script(study, true);
    script.reach_pairs();
    script.answer_pair(20, 0, true);
    script.answer_pair(40, 1, false);
    const auto trials = script.rows_of<TrialRecord>();
    EXPECT_EQ(trials[0].first_shown, 'B');
    EXPECT_EQ(trials[0].first_sha256.substr(0, 2), "b2");
    EXPECT_FALSE(trials[0].is_A_selected);
    EXPECT_TRUE(trials[1].is_A_selected);
}

TEST(Procedure, TheSessionRowHoldsTheFormTheOrderAndTheMachine) {
    const stimuli::Study study = small_study(3);
    Script script(study);
    script.reach_pairs();
    ASSERT_TRUE(std::holds_alternative<BeginSession>(script.rows.at(0)));
    const auto& begin = std::get<BeginSession>(script.rows[0]);
    EXPECT_EQ(begin.participant.age_years, 30);
    EXPECT_EQ(begin.participant.gender, "female");
    EXPECT_EQ(begin.participant.normal_vision, true);
    EXPECT_EQ(begin.participant.naive, std::nullopt);
    EXPECT_TRUE(begin.participant.consent);
    EXPECT_EQ(begin.session.study, "small");
    EXPECT_EQ(begin.session.order, "latin-square");
    EXPECT_EQ(begin.session.slot, 3U);
    EXPECT_EQ(begin.session.condition_count, 3);
    EXPECT_EQ(begin.session.started_utc, "t4");
    EXPECT_EQ(begin.session.gpu_renderer, "a renderer");
    ASSERT_EQ(begin.events.size(), 1U);
    const EventRecord& digest = begin.events[0];
    EXPECT_EQ(digest.name, kStimuliEvent);
    EXPECT_EQ(digest.detail, digest_of(script.procedure.plan().images));
}

TEST(Procedure, AFormWithoutConsentOrWithAnImpossibleAgeStaysOnTheForm) {
    const stimuli::Study study = small_study(2);
    for (const std::optional<int> age : {std::optional<int>(), {0}, {121}, {-1}}) {
        Form form = Script::filled_form();
        form.age_years = age;
        EXPECT_FALSE(problems_of(form, study).none());
        EXPECT_FALSE(problems_of(form, study).consent);
        Script script(study);
        script.shown_at(0);
        script.at(1, StartPressed{});
        script.shown_at(2);
        script.at(3, FormSubmitted{form});
        EXPECT_EQ(script.procedure.screen(), Screen::kForm);
        EXPECT_TRUE(script.rows.empty());
    }
    Form form = Script::filled_form();
    form.consent = false;
    EXPECT_TRUE(problems_of(form, study).consent);
    form = {.age_years = 1, .gender = "", .normal_vision = {}, .naive = {}, .consent = true};
    EXPECT_TRUE(problems_of(form, study).none());
}

TEST(Procedure, NothingShortensTheGreyInterval) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(22, SpacePressed{});
    EXPECT_EQ(script.procedure.next_due_s(), std::nullopt);  // not visible yet
    script.shown_at(23);
    EXPECT_EQ(script.procedure.next_due_s(), 25.0);
    const std::vector<Event> tries{SpacePressed{}, Answered{true},    PairPressed{0},
                                   PairPressed{1}, NextParticipant{}, InstructionsRead{},
                                   StartPressed{}, Tick{24.999999}};
    for (const Event& event : tries) {
        script.at(24, event);
        EXPECT_EQ(script.procedure.screen(), Screen::kInterval);
    }
    script.at(24.99, Tick{25.0});
    EXPECT_EQ(script.procedure.screen(), Screen::kSecondImage);
}

TEST(Procedure, SpaceBeforeAnImageIsVisibleDoesNotCount) {
    stimuli::Study study = small_study(2);
    study.presentation.input_delay_ms = 0;
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.at(20.5, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    script.shown_at(21);
    script.at(20.9, SpacePressed{});  // pressed before, delivered after
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    script.at(21, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval);
}

TEST(Procedure, OnlyTheNextPairsButtonDoesSomething) {
    const stimuli::Study study = small_study(3);
    Script script(study);
    script.reach_pairs();
    script.at(11, PairPressed{1});
    script.at(11, PairPressed{-1});
    EXPECT_EQ(script.procedure.screen(), Screen::kPairs);
    script.answer_pair(20, 0, true);
    script.at(40, PairPressed{0});
    EXPECT_EQ(script.procedure.screen(), Screen::kPairs);
    script.at(41, PairPressed{1});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
}

TEST(Procedure, TheOperatorsQuestionIsNoViewingTimeAndStayingReturnsToTheSameScreen) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(23, LeaveRequested{});
    EXPECT_EQ(script.procedure.screen(), Screen::kConfirmLeave);
    script.shown_at(24);
    script.at(30, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kConfirmLeave);
    script.at(33, LeaveCancelled{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    script.shown_at(34);
    script.at(37, SpacePressed{});
    script.shown_at(38);
    script.at(39, LeaveRequested{});  // a grey interval interrupted starts anew
    script.shown_at(39.5);
    script.at(60, Tick{60});
    script.at(61, LeaveCancelled{});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval);
    script.shown_at(62);
    script.at(63, Tick{63});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval);
    script.at(64, Tick{64});
    script.shown_at(64);
    script.at(65, SpacePressed{});
    script.shown_at(66);
    script.at(67, LeaveRequested{});
    script.shown_at(68);
    script.at(70, LeaveCancelled{});
    script.shown_at(71);
    script.at(73, Answered{true});
    const TrialRecord row = script.rows_of<TrialRecord>().at(0);
    EXPECT_NEAR(row.first_view_ms, 5000.0, 1e-9);
    EXPECT_DOUBLE_EQ(row.first_onset_s, 17.0);
    EXPECT_NEAR(row.grey_ms_measured, 2000.0, 1e-9);
    EXPECT_DOUBLE_EQ(row.question_onset_s, 62.0);
    EXPECT_DOUBLE_EQ(row.response_time_s, 3.0);
    std::vector<std::string> names;
    for (const EventRecord& event : script.rows_of<EventRecord>()) names.push_back(event.name);
    EXPECT_EQ(std::count(names.begin(), names.end(), "operator asked to leave"), 3);
    EXPECT_EQ(std::count(names.begin(), names.end(), "operator stayed"), 3);
}

TEST(Procedure, HiddenTimeIsTheTrialsOwnColumnAndNoViewingOrResponseTime) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(22, ScreenHidden{"lost focus"});
    script.at(23, ScreenHidden{"iconified"});
    script.at(26, ScreenSeen{});
    script.shown_at(27);              // hidden for 5 s
    script.at(29, SpacePressed{});    // seen for 1 + 2 s
    script.shown_at(30);              // grey
    script.at(31, LeaveRequested{});  // the operator's question covers it for 3 s
    script.shown_at(31.5);
    script.at(32, LeaveCancelled{});
    script.shown_at(34);  // grey starts anew
    script.at(36, Tick{36});
    script.shown_at(36);
    script.at(40, SpacePressed{});
    script.shown_at(41);
    script.at(42, ScreenHidden{"covered"});
    script.at(44, ScreenSeen{});
    script.shown_at(44.5);          // hidden for 2.5 s
    script.at(45, Answered{true});  // after 1 + 0.5 s
    const TrialRecord trial = script.rows_of<TrialRecord>().at(0);
    EXPECT_DOUBLE_EQ(trial.hidden_ms.value(), 5000.0 + 3000.0 + 2500.0);
    EXPECT_DOUBLE_EQ(trial.first_view_ms, 3000.0);
    EXPECT_DOUBLE_EQ(trial.grey_ms_measured, 2000.0);
    EXPECT_DOUBLE_EQ(trial.second_view_ms, 4000.0);
    EXPECT_DOUBLE_EQ(trial.response_time_s, 1.5);
    std::vector<std::string> events;
    for (const auto& event : script.rows_of<EventRecord>()) {
        if (event.name != kStimuliEvent) events.push_back(event.name + ": " + event.detail);
    }
    const std::vector<std::string> expected{"instructions read: ",
                                            "lost focus: pair 1, first image",
                                            "iconified: pair 1, first image",
                                            "seen again: after 4000 ms, pair 1, first image",
                                            "operator asked to leave: ",
                                            "operator stayed: ",
                                            "covered: pair 1, question",
                                            "seen again: after 2000 ms, pair 1, question"};
    EXPECT_EQ(events, expected);
    script.shown_at(46);
    script.answer_pair(50, 1, true);
    EXPECT_DOUBLE_EQ(script.rows_of<TrialRecord>().at(1).hidden_ms.value(), 0.0);
}

TEST(Procedure, NothingIsTakenWhileTheScreenIsHiddenButTheOperatorsWishToLeave) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(22, ScreenHidden{"covered"});
    script.shown_at(23);
    script.at(24, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    script.at(25, LeaveRequested{});
    EXPECT_EQ(script.procedure.screen(), Screen::kConfirmLeave);
    script.shown_at(26);
    script.at(27, LeaveCancelled{});
    script.shown_at(28);
    script.at(29, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage) << "still hidden";
    const int before = script.procedure.request();
    script.at(30, ScreenSeen{});
    EXPECT_GT(script.procedure.request(), before) << "to be shown again";
    script.at(31, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage) << "not visible yet";
    script.shown_at(32);
    script.at(33, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval);
    script.shown_at(34);
    script.at(35, ScreenHidden{"resized"});
    EXPECT_FALSE(script.procedure.next_due_s());
    script.at(40, Tick{40});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval) << "no interval ends unseen";
    script.at(41, ScreenSeen{});
    script.shown_at(42);
    script.at(43, Tick{43});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval) << "it starts anew";
    script.at(44, Tick{44});
    script.shown_at(44);
    script.at(46, SpacePressed{});
    script.shown_at(47);
    script.at(48, ScreenHidden{"monitor lost"});
    script.at(49, Answered{true});
    EXPECT_TRUE(script.rows_of<TrialRecord>().empty()) << "no answer to what cannot be seen";
}

TEST(Procedure, LeavingEndsItAndLeavesTheSessionOpen) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(11, LeaveRequested{});
    script.shown_at(12);
    script.at(13, LeaveConfirmed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kLeft);
    EXPECT_EQ(std::get<EventRecord>(script.rows.back()).name, "operator left");
    EXPECT_TRUE(script.rows_of<CompleteSession>().empty());
    script.at(14, LeaveCancelled{});
    EXPECT_EQ(script.procedure.screen(), Screen::kLeft);
}

TEST(Procedure, ContinuesACutOffSessionAtTheFirstUnansweredPair) {
    const stimuli::Study study = small_study(3);
    Script before(study);
    before.reach_pairs();
    before.answer_pair(20, 0, true);
    Script after(study);
    const auto rows =
        after.procedure.resume(before.rows_of<TrialRecord>(), true, 500.0, {7.0, "u"});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(std::get<EventRecord>(rows[0]).name, "session resumed");
    EXPECT_EQ(std::get<EventRecord>(rows[0]).session_id, "s-1");
    EXPECT_EQ(after.procedure.screen(), Screen::kPairs);
    after.shown_at(8);
    after.answer_pair(9, 1, true);
    after.answer_pair(29, 2, true);
    const auto trials = after.rows_of<TrialRecord>();
    EXPECT_EQ(trials.at(0).trial_index, 1);
    EXPECT_DOUBLE_EQ(trials.at(0).first_onset_s, 503.0);
    EXPECT_EQ(after.rows_of<CompleteSession>().size(), 1U);
    EXPECT_TRUE(after.rows_of<BeginSession>().empty());
}

TEST(Procedure, ASessionCutOffAfterItsLastAnswerIsCompletedWhenContinued) {
    const stimuli::Study study = small_study(2);
    Script before(study);
    before.reach_pairs();
    before.answer_pair(20, 0, true);
    before.answer_pair(40, 1, true);
    Script after(study);
    const auto rows =
        after.procedure.resume(before.rows_of<TrialRecord>(), true, 500.0, {7.0, "u"});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<CompleteSession>(rows[1]));
    EXPECT_EQ(after.procedure.screen(), Screen::kThanks);
}

TEST(Procedure, AnswersThatAreNotOfThePlanCannotBeContinued) {
    const stimuli::Study study = small_study(2);
    Script before(study);
    before.reach_pairs();
    before.answer_pair(20, 0, true);
    auto trials = before.rows_of<TrialRecord>();
    trials[0].condition = "C1";
    Script after(study);
    EXPECT_THROW((void)after.procedure.resume(trials, true, 1.0, {0.0, "u"}), base::Error);
    trials[0].condition = "C2";
    trials[0].trial_index = 1;
    EXPECT_THROW((void)after.procedure.resume(trials, true, 1.0, {0.0, "u"}), base::Error);
}

}  // namespace
}  // namespace obscura::app::kiosk
