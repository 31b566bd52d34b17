// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What reaches a page: nothing from before it was seen.
#include <gtest/gtest.h>

#include <functional>

#include "tests/app/kiosk/script.h"

namespace obscura::app::kiosk {
namespace {

using analysis::EventRecord;
using analysis::TrialRecord;

/// Every screen that a participant can leave, how to reach it with its onset at `time_s`, and what
/// leaves it.
struct Stop {
    Screen screen;
    Event leaves;
    std::function<void(Script&, double time_s)> reach;
};

void press(Script& script, const Event& event, double pressed_s, double time_s) {
    for (Row& row : script.procedure.step(event, {time_s, "u", pressed_s})) {
        script.rows.push_back(std::move(row));
    }
}

std::vector<Stop> stops() {
    const auto to_pair = [](Script& script) {
        script.reach_pairs();
        script.at(20, PairPressed{0});
    };
    const auto to_second = [to_pair](Script& script) {
        to_pair(script);
        script.shown_at(21);
        script.at(24, SpacePressed{});
        script.shown_at(25);
        script.at(28, Tick{28});
    };
    return {
        {Screen::kStart, StartPressed{}, [](Script& script, double t) { script.shown_at(t); }},
        {Screen::kForm, FormSubmitted{Script::filled_form()},
         [](Script& script, double t) {
             script.shown_at(0);
             script.at(1, StartPressed{});
             script.shown_at(t);
         }},
        {Screen::kInstructions, InstructionsRead{},
         [](Script& script, double t) {
             script.shown_at(0);
             script.at(1, StartPressed{});
             script.shown_at(2);
             script.at(4, FormSubmitted{Script::filled_form()});
             script.shown_at(t);
         }},
        {Screen::kPairs, PairPressed{1},
         [](Script& script, double t) {
             script.reach_pairs();
             script.answer_pair(20, 0, true);
             script.at(40, LeaveRequested{});
             script.shown_at(41);
             script.at(42, LeaveCancelled{});
             script.shown_at(t);
         }},
        {Screen::kFirstImage, SpacePressed{},
         [=](Script& script, double t) {
             to_pair(script);
             script.shown_at(t);
         }},
        {Screen::kSecondImage, SpacePressed{},
         [=](Script& script, double t) {
             to_second(script);
             script.shown_at(t);
         }},
        {Screen::kQuestion, Answered{true},
         [=](Script& script, double t) {
             to_second(script);
             script.shown_at(29);
             script.at(32, SpacePressed{});
             script.shown_at(t);
         }},
        {Screen::kThanks, NextParticipant{},
         [](Script& script, double t) {
             script.reach_pairs();
             script.answer_pair(20, 0, true);
             script.at(40, PairPressed{1});
             script.shown_at(41);
             script.at(44, SpacePressed{});
             script.shown_at(45);
             script.at(48, Tick{48});
             script.shown_at(49);
             script.at(50, SpacePressed{});
             script.shown_at(51);
             script.at(52, Answered{true});
             script.shown_at(t);
         }},
        {Screen::kConfirmLeave, LeaveConfirmed{},
         [](Script& script, double t) {
             script.reach_pairs();
             script.at(20, LeaveRequested{});
             script.shown_at(t);
         }},
    };
}

TEST(ProcedureInput, NoPageTakesWhatWasPressedBeforeItsDelayHoweverLateItComes) {
    const stimuli::Study study = small_study(2);
    ASSERT_EQ(study.presentation.input_delay_ms, 300);
    for (const Stop& stop : stops()) {
        Script script(study);
        stop.reach(script, 100.0);
        ASSERT_EQ(script.procedure.screen(), stop.screen);
        const auto rows = script.rows.size();
        // Held since the page before, released or repeated long after; then the second click of a
        // double one.
        for (const auto& [pressed_s, time_s] :
             {std::pair{99.0, 105.0}, {99.99, 106.0}, {100.0, 107.0}, {100.299, 108.0}}) {
            press(script, stop.leaves, pressed_s, time_s);
            EXPECT_EQ(script.procedure.screen(), stop.screen) << "pressed at " << pressed_s;
        }
        EXPECT_EQ(script.rows.size(), rows);
        press(script, stop.leaves, 108.3, 108.4);
        EXPECT_NE(script.procedure.screen(), stop.screen);
    }
}

TEST(ProcedureInput, TheDelayIsTheStudys) {
    for (const int delay_ms : {0, 50, 5000}) {
        stimuli::Study study = small_study(2);
        study.presentation.input_delay_ms = delay_ms;
        for (const Stop& stop : stops()) {
            if (delay_ms > 300 && stop.screen != Screen::kStart) continue;  // the way there is fast
            Script script(study);
            stop.reach(script, 100.0);
            const double from_s = 100.0 + delay_ms / 1000.0;
            EXPECT_DOUBLE_EQ(script.procedure.takes_presses_from_s(), from_s);
            press(script, stop.leaves, from_s - 0.001, from_s);
            EXPECT_EQ(script.procedure.screen(), stop.screen);
            press(script, stop.leaves, from_s, from_s + 0.01);
            EXPECT_NE(script.procedure.screen(), stop.screen);
        }
    }
}

TEST(ProcedureInput, APageIsLeftOnlyAfterItsEndWasSeenAndNotByWhatScrolledThere) {
    const stimuli::Study study = small_study(2);
    for (const Stop& stop : stops()) {
        if (stop.screen == Screen::kFirstImage || stop.screen == Screen::kSecondImage) continue;
        Script script(study);
        stop.reach(script, 100.0);
        // The same page, but shown again with its end out of view.
        script.at(101, LeaveRequested{});
        if (stop.screen == Screen::kConfirmLeave) continue;
        script.shown_at(102);
        script.at(103, LeaveCancelled{});
        script.at(104, ScreenPresented{0, false});
        script.at(150, stop.leaves);
        EXPECT_EQ(script.procedure.screen(), stop.screen);
        script.at(160, EndSeen{});
        press(script, stop.leaves, 159.9, 160.5);
        press(script, stop.leaves, 160.29, 160.6);
        EXPECT_EQ(script.procedure.screen(), stop.screen);
        script.at(170, EndSeen{});  // seen once is enough: it does not begin anew
        script.at(170.1, stop.leaves);
        EXPECT_NE(script.procedure.screen(), stop.screen);
    }
}

TEST(ProcedureInput, TheOperatorNeedNotWaitToAsk) {
    stimuli::Study study = small_study(2);
    study.presentation.input_delay_ms = 5000;
    Script script(study);
    script.at(0, ScreenPresented{0, false});
    script.at(0.1, LeaveRequested{});
    EXPECT_EQ(script.procedure.screen(), Screen::kConfirmLeave);
}

TEST(ProcedureInput, AfterTheOperatorsQuestionAPageTakesNothingAtFirstEither) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(23, LeaveRequested{});
    script.shown_at(24);
    script.at(25, LeaveCancelled{});
    script.shown_at(26);
    script.at(26.2, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    script.at(26.4, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kInterval);
}

TEST(ProcedureInput, AnImageHiddenAndAskedAboutBeforeItWasEverSeenBeginsWhenItIsSeen) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.at(20.5, ScreenHidden{"lost focus"});
    script.at(21, LeaveRequested{});
    script.shown_at(22);
    script.at(23, LeaveCancelled{});
    script.at(24, ScreenSeen{});
    script.shown_at(25);
    script.at(28, SpacePressed{});
    script.shown_at(28.01);
    script.at(30.01, Tick{30.01});
    script.shown_at(30.02);
    script.at(34.02, SpacePressed{});
    script.shown_at(35);
    script.at(36.5, Answered{true});
    const TrialRecord row = script.rows_of<TrialRecord>().at(0);
    EXPECT_DOUBLE_EQ(row.first_onset_s, 21.0);
    EXPECT_NEAR(row.first_view_ms, 3000.0, 1e-9);
    EXPECT_NEAR(row.grey_ms_measured, 2010.0, 1e-9);
}

TEST(ProcedureInput, ContinuingShowsTheInstructionsUnlessTheyWereReadAndAPairWasAnswered) {
    const stimuli::Study study = small_study(3);
    Script before(study);
    before.reach_pairs();
    before.answer_pair(20, 0, true);
    const auto answered = before.rows_of<TrialRecord>();
    const auto screen_after = [&](const std::vector<TrialRecord>& trials, bool read) {
        Script after(study);
        (void)after.procedure.resume(trials, read, 500.0, {7.0, "u"});
        return after.procedure.screen();
    };
    EXPECT_EQ(screen_after({}, false), Screen::kInstructions);
    EXPECT_EQ(screen_after({}, true), Screen::kInstructions);
    EXPECT_EQ(screen_after(answered, false), Screen::kInstructions);
    EXPECT_EQ(screen_after(answered, true), Screen::kPairs);

    Script after(study);
    (void)after.procedure.resume(answered, false, 500.0, {7.0, "u"});
    after.shown_at(8);
    after.at(9, InstructionsRead{});
    EXPECT_EQ(after.procedure.screen(), Screen::kPairs);
    EXPECT_EQ(after.procedure.pair(), 1);
    EXPECT_EQ(after.rows_of<EventRecord>().back().name, kInstructionsReadEvent);
}

}  // namespace
}  // namespace obscura::app::kiosk
