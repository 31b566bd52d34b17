// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/procedure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "tests/kiosk/small_study.h"

namespace obscura::app::kiosk {
namespace {

using analysis::EventRecord;
using analysis::TrialRecord;

/// A procedure with a script: every call happens at the time given.
class Script {
  public:
    explicit Script(const stimuli::Study& study, bool swapped = false)
        : procedure(study, small_plan(study, swapped)) {}

    void at(double time_s, const Event& event) {
        for (Row& row : procedure.step(event, {time_s, fmt::format("t{}", time_s)})) {
            rows.push_back(std::move(row));
        }
    }
    void shown_at(double time_s) { at(time_s, ScreenPresented{}); }

    /// From the start to the page of pairs, visible at 10 s; the session begins at 4 s.
    void reach_pairs() {
        shown_at(0);
        at(1, StartPressed{});
        shown_at(2);
        at(4, FormSubmitted{filled_form()});
        shown_at(5);
        at(9, InstructionsRead{});
        shown_at(10);
    }

    /// One pair from time `t`: first image from t+1 for 3 s, second from t+6.02 for 4 s, question
    /// from t+11 for 1.5 s; then the next screen at t+13.
    void answer_pair(double t, int pair, bool first) {
        at(t, PairPressed{pair});
        shown_at(t + 1);
        at(t + 4, SpacePressed{});
        shown_at(t + 4.01);
        at(t + 6.01, Tick{t + 6.01});
        shown_at(t + 6.02);
        at(t + 10.02, SpacePressed{});
        shown_at(t + 11);
        at(t + 12.5, Answered{first});
        shown_at(t + 13);
    }

    static Form filled_form() {
        return {.age_years = 30,
                .gender = "female",
                .normal_vision = true,
                .naive = std::nullopt,
                .consent = true};
    }

    template <typename T>
    [[nodiscard]] std::vector<T> rows_of() const {
        std::vector<T> found;
        for (const Row& row : rows) {
            if (const T* match = std::get_if<T>(&row)) found.push_back(*match);
        }
        return found;
    }

    Procedure procedure;
    std::vector<Row> rows;
};

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
    const auto& digest = std::get<EventRecord>(script.rows.at(1));
    EXPECT_EQ(digest.name, kStimuliEvent);
    EXPECT_EQ(digest.detail, digest_of(script.procedure.plan().images));
}

TEST(Procedure, AFormWithoutConsentOrWithAnImpossibleAgeStaysOnTheForm) {
    const stimuli::Study study = small_study(2);
    for (const std::optional<int> age : {std::optional<int>(), {0}, {121}, {-1}}) {
        Form form = Script::filled_form();
        form.age_years = age;
        EXPECT_FALSE(problems_of(form).none());
        EXPECT_TRUE(problems_of(form).consent.empty());
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
    EXPECT_FALSE(problems_of(form).consent.empty());
    form = {.age_years = 1, .gender = "", .normal_vision = {}, .naive = {}, .consent = true};
    EXPECT_TRUE(problems_of(form).none());
}

TEST(Procedure, NothingShortensTheGreyInterval) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(22, SpacePressed{});
    EXPECT_EQ(script.procedure.second_image_due_s(), std::nullopt);  // not visible yet
    script.shown_at(23);
    EXPECT_EQ(script.procedure.second_image_due_s(), 25.0);
    const std::vector<Event> tries{SpacePressed{}, Answered{true},    PairPressed{0},
                                   PairPressed{1}, NextParticipant{}, InstructionsRead{},
                                   StartPressed{}, Tick{24.999999}};
    for (const Event& event : tries) {
        script.at(24, event);
        EXPECT_EQ(script.procedure.screen(), Screen::kGrey);
    }
    script.at(24.99, Tick{25.0});
    EXPECT_EQ(script.procedure.screen(), Screen::kSecondImage);
}

TEST(Procedure, SpaceBeforeAnImageIsVisibleDoesNotCount) {
    const stimuli::Study study = small_study(2);
    Script script(study);
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.at(20.5, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    script.shown_at(21);
    script.at(20.9, SpacePressed{});  // pressed before, delivered after
    EXPECT_EQ(script.procedure.screen(), Screen::kFirstImage);
    script.at(21, SpacePressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kGrey);
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
    EXPECT_EQ(script.procedure.screen(), Screen::kGrey);
    script.shown_at(62);
    script.at(63, Tick{63});
    EXPECT_EQ(script.procedure.screen(), Screen::kGrey);
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
    const auto rows = after.procedure.resume(before.rows_of<TrialRecord>(), 500.0, {7.0, "u"});
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
    const auto rows = after.procedure.resume(before.rows_of<TrialRecord>(), 500.0, {7.0, "u"});
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
    EXPECT_THROW((void)after.procedure.resume(trials, 1.0, {0.0, "u"}), base::Error);
    trials[0].condition = "C2";
    trials[0].trial_index = 1;
    EXPECT_THROW((void)after.procedure.resume(trials, 1.0, {0.0, "u"}), base::Error);
}

Event random_event(base::Random& random, int pairs, double time_s) {
    switch (random.below(13)) {
        case 0:
            return StartPressed{};
        case 1: {
            Form form = Script::filled_form();
            form.consent = random.below(2) == 0;
            form.age_years = static_cast<int>(random.below(140)) - 10;
            return FormSubmitted{form};
        }
        case 2:
            return InstructionsRead{};
        case 3:
        case 4:
            return PairPressed{static_cast<int>(random.below(pairs + 2)) - 1};
        case 5:
            return SpacePressed{};
        case 6:
            return Answered{random.below(2) == 0};
        case 7:
            return NextParticipant{};
        case 8:
            return Tick{time_s + random.uniform(-1.0, 1.0)};
        case 9:
            return random.below(20) == 0 ? Event(LeaveRequested{}) : Event(SpacePressed{});
        case 10:
            return random.below(20) == 0 ? Event(LeaveConfirmed{}) : Event(LeaveCancelled{});
        default:
            return ScreenPresented{static_cast<int>(random.below(3))};
    }
}

void expect_sound(const TrialRecord& row, int index, const stimuli::Study& study) {
    EXPECT_EQ(row.trial_index, index);
    EXPECT_GE(row.first_view_ms, 0.0);
    EXPECT_GE(row.second_view_ms, 0.0);
    EXPECT_GE(row.response_time_s, 0.0);
    EXPECT_GE(row.dropped_frames, 0);
    EXPECT_GE(row.first_onset_s, 0.0);
    EXPECT_GT(row.second_onset_s, row.first_onset_s);
    EXPECT_GE(row.question_onset_s, row.second_onset_s);
    EXPECT_GE(row.grey_ms_measured, study.grey_ms - 1000.0);  // a tick may expect 1 s ahead
}

TEST(Procedure, RandomEventsNeverGiveARowOutOfOrderADuplicateANegativeTimeOrAWayBack) {
    const stimuli::Study study = small_study(4);
    std::set<Screen> seen;
    int completed = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        base::Random random(seed);
        Script script(study, seed % 2 == 1);
        double time_s = 0.0;
        std::set<std::pair<int, int>> images_left;  // pair and position no longer to be seen
        Screen last = Screen::kStart;
        int last_pair = 0;
        for (int i = 0; i < 1500; ++i) {
            time_s += random.uniform(0.0, 0.5);
            const double stamped = random.below(10) == 0 ? time_s - 1.0 : time_s;
            script.at(stamped, random_event(random, 4, stamped));
            const Screen now = script.procedure.screen();
            seen.insert(now);
            const int pair = script.procedure.pair();
            EXPECT_GE(pair, last_pair);
            if (last == Screen::kFirstImage && now == Screen::kGrey) images_left.insert({pair, 0});
            if (last == Screen::kSecondImage && now == Screen::kQuestion) {
                images_left.insert({pair, 1});
            }
            if (now == Screen::kFirstImage) {
                EXPECT_FALSE(images_left.contains({pair, 0}));
            }
            if (now == Screen::kSecondImage) {
                EXPECT_FALSE(images_left.contains({pair, 1}));
            }
            last = now;
            last_pair = pair;
        }
        const auto trials = script.rows_of<TrialRecord>();
        for (std::size_t i = 0; i < trials.size(); ++i) {
            expect_sound(trials[i], static_cast<int>(i), study);
        }
        EXPECT_LE(script.rows_of<BeginSession>().size(), 1U);
        const std::size_t ends = script.rows_of<CompleteSession>().size();
        EXPECT_EQ(ends, trials.size() == 4 ? 1U : 0U);
        completed += static_cast<int>(ends);
    }
    EXPECT_GT(completed, 5);
    EXPECT_EQ(seen.size(), 12U) << "every screen is reached";
}

}  // namespace
}  // namespace obscura::app::kiosk
