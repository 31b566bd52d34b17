// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Several questions of a pair: their pages, their rows, and a session that is cut off among them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "analysis/questions/answers.h"
#include "analysis/store/store.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "tests/app/kiosk/asking_study.h"
#include "tests/app/kiosk/script.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using analysis::EventRecord;
using analysis::QuestionAnswer;
using analysis::TrialRecord;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<QuestionAnswer> answers_of(const Script& script) {
    return analysis::answers_among(script.rows_of<EventRecord>());
}

/// One answer a second from time `t` on, each a second after its page is seen.
void answer_all(Script& script, double t, const std::vector<int>& answers) {
    for (const int answer : answers) {
        script.at(t, AnswerPressed{answer});
        script.shown_at(t + 0.1);
        t += 1.1;
    }
}

/// The first pair up to its question, which is visible at 31 s.
void reach_question(Script& script) {
    script.reach_pairs();
    script.at(20, PairPressed{0});
    script.shown_at(21);
    script.at(24, SpacePressed{});
    script.shown_at(24.01);
    script.at(26.01, Tick{26.01});
    script.shown_at(26.02);
    script.at(30.02, SpacePressed{});
    script.shown_at(31);
}

TEST(QuestionsOfAPair, HaveAPageEachInTheirOrderAndThePairEndsWithTheLast) {
    const stimuli::Study study = small_study(2);
    Script script(study, asking_plan(study));
    reach_question(script);
    EXPECT_EQ(script.procedure.asked().question->id, "real");
    script.at(32.5, AnswerPressed{1});
    EXPECT_EQ(script.procedure.screen(), Screen::kQuestion);
    EXPECT_EQ(script.procedure.asked().question->id, "sure");
    EXPECT_EQ(script.procedure.pair(), 0);
    script.shown_at(33);
    script.at(35, AnswerPressed{4});
    EXPECT_EQ(script.procedure.asked().question->id, "like");
    EXPECT_EQ(script.procedure.asked().image, 1);
    script.shown_at(36);
    script.at(37, AnswerPressed{6});
    EXPECT_EQ(script.procedure.asked().image, 2);
    script.shown_at(38);
    script.at(39, AnswerPressed{1});
    EXPECT_EQ(script.procedure.screen(), Screen::kPairs);
    EXPECT_EQ(script.procedure.pair(), 1);

    const auto trials = script.rows_of<TrialRecord>();
    ASSERT_THAT(trials, SizeIs(1));
    EXPECT_FALSE(trials[0].response_first);
    EXPECT_DOUBLE_EQ(trials[0].question_onset_s, 27.0);
    EXPECT_DOUBLE_EQ(trials[0].response_time_s, 1.5);
    const auto answers = answers_of(script);
    ASSERT_THAT(answers, SizeIs(3));
    EXPECT_EQ(answers[0].question, "sure");
    EXPECT_EQ(answers[0].question_kind, "confidence");
    EXPECT_EQ(answers[0].answer, "5");
    EXPECT_EQ(answers[0].label, "very");
    EXPECT_EQ(answers[0].condition, "C2");
    EXPECT_EQ(answers[0].trial_index, 0);
    EXPECT_DOUBLE_EQ(answers[0].response_time_s, 2.0);
    EXPECT_EQ(answers[1].about, "A");  // shown first
    EXPECT_EQ(answers[1].answer, "7");
    EXPECT_EQ(answers[1].label, "wholly");
    EXPECT_EQ(answers[2].about, "B");
    EXPECT_EQ(answers[2].answer, "2");
    EXPECT_EQ(answers[2].label, "2") << "a step between the ends has its number";
}

TEST(QuestionsOfAPair, TakeNothingButTheirOwnAnswersAfterTheyAreSeen) {
    const stimuli::Study study = small_study(2);
    Script script(study, asking_plan(study));
    reach_question(script);
    script.at(32, AnswerPressed{2});  // a plain choice has no third
    script.at(32.1, AnswerPressed{-1});
    EXPECT_THAT(script.rows_of<TrialRecord>(), SizeIs(0));
    script.at(33, Answered{true});
    script.at(33.1, AnswerPressed{1});  // not visible yet
    script.shown_at(34);
    script.at(34.2, AnswerPressed{1});  // within the input delay
    EXPECT_EQ(script.procedure.asked().question->id, "sure");
    EXPECT_THAT(answers_of(script), SizeIs(0));
    script.at(35, AnswerPressed{1});
    EXPECT_THAT(answers_of(script), SizeIs(1));
}

TEST(QuestionsOfAPair, WithoutADifferenceACoinThatSessionAndPairFixGivesTheTrial) {
    const stimuli::Study study = small_study(2);
    std::set<bool> sides;
    for (int number = 0; number < 16; ++number) {
        std::optional<bool> selected;
        for (const bool swapped : {false, true}) {
            SessionPlan plan = asking_plan(study, swapped);
            plan.session_id = fmt::format("s-{}", number);
            plan.questions.list[0].kind = stimuli::QuestionKind::kChoiceOrNone;
            Script script(study, std::move(plan));
            reach_question(script);
            script.at(32, AnswerPressed{2});
            const auto trials = script.rows_of<TrialRecord>();
            ASSERT_THAT(trials, SizeIs(1));
            // The side of the condition, whichever is shown first.
            EXPECT_EQ(selected.value_or(trials[0].is_A_selected), trials[0].is_A_selected);
            selected = trials[0].is_A_selected;
            const auto answers = answers_of(script);
            ASSERT_THAT(answers, SizeIs(1));
            EXPECT_EQ(answers[0].answer, "none");
            EXPECT_EQ(answers[0].label, "No difference");
            EXPECT_FALSE(script.procedure.chose_first().has_value());
            EXPECT_EQ(script.procedure.asked().question->id, "sure");
        }
        sides.insert(*selected);
    }
    EXPECT_THAT(sides, SizeIs(2)) << "a coin has two sides";
}

TEST(QuestionsOfAPair, WithoutADifferenceAnAttentionCheckIsNotPassed) {
    stimuli::Study study = small_study(2);
    for (stimuli::Condition& condition : study.conditions) condition.expected = 'A';
    for (int number = 0; number < 8; ++number) {
        SessionPlan plan = asking_plan(study);
        plan.session_id = fmt::format("s-{}", number);
        plan.questions.list[0].kind = stimuli::QuestionKind::kChoiceOrNone;
        Script script(study, std::move(plan));
        reach_question(script);
        script.at(32, AnswerPressed{2});
        EXPECT_FALSE(script.rows_of<TrialRecord>().at(0).is_A_selected);
    }
}

TEST(QuestionsOfAPair, GoOnAfterTheLastAnswerWhereTheSessionWasCutOff) {
    const stimuli::Study study = small_study(2);
    Script whole(study, asking_plan(study));
    reach_question(whole);
    answer_all(whole, 32, {0, 2, 3});
    Procedure rest(study, asking_plan(study));
    const auto rows = rest.resume(whole.rows_of<TrialRecord>(), true, 100.0, {0.0, "t", 0.0},
                                  whole.rows_of<EventRecord>());
    EXPECT_THAT(rows, SizeIs(1)) << "the event alone";
    EXPECT_EQ(rest.screen(), Screen::kQuestion);
    EXPECT_EQ(rest.asked().question->id, "like");
    EXPECT_EQ(rest.asked().image, 2);
    EXPECT_EQ(rest.pair(), 0);
    EXPECT_TRUE(rest.session_open());
}

TEST(QuestionsOfAPair, OfTheLastPairAreAskedBeforeACutOffSessionIsComplete) {
    const stimuli::Study study = small_study(1);
    stimuli::Study fixed = study;
    fixed.order = stimuli::OrderKind::kFixed;
    Script whole(fixed, asking_plan(fixed));
    reach_question(whole);
    answer_all(whole, 32, {0});
    Procedure rest(fixed, asking_plan(fixed));
    (void)rest.resume(whole.rows_of<TrialRecord>(), true, 100.0, {0.0, "t", 0.0},
                      whole.rows_of<EventRecord>());
    EXPECT_EQ(rest.screen(), Screen::kQuestion);
    EXPECT_EQ(rest.asked().question->id, "sure");
}

/// A session into a store whose program is killed, again and again, at any of its rows.
class KilledSession {
  public:
    explicit KilledSession(std::uint64_t seed) : random_(seed) {}

    /// Times it was killed before it was complete.
    int run() {
        int kills = 0;
        while (!go_on(static_cast<int>(1 + random_.below(5)))) ++kills;
        return kills;
    }
    [[nodiscard]] analysis::Store store() const {
        return {url_, analysis::Store::Access::kReadWrite};
    }

  private:
    struct Killed {};

    bool go_on(int rows) {
        analysis::Store store(url_, analysis::Store::Access::kThrowaway);
        // What the store has acknowledged is all that the next program knows.
        Journal journal([&](const Row& row) {
            if (rows-- == 0) throw Killed();
            commit(store, row);
        });
        Procedure procedure(study_, plan());
        VirtualClock clock;
        clock.pass(now_s_ += 1000.0);
        const auto sessions = store.sessions();
        if (!sessions.empty()) {
            const auto events = store.events();
            const bool read = std::any_of(events.begin(), events.end(), [](const auto& event) {
                return event.name == kInstructionsReadEvent;
            });
            journal.add(procedure.resume(store.trials(), read, now_s_, clock.now(), events));
        }
        try {
            simulate_observer(procedure, choices_from(study_, {}), random_, clock, journal);
        } catch (const Killed&) {
            return false;
        }
        return true;
    }
    [[nodiscard]] SessionPlan plan() const {
        SessionPlan plan = asking_plan(study_);
        plan.kind = analysis::Kind::kSimulated;
        plan.questions.list[0].kind = stimuli::QuestionKind::kChoiceOrNone;
        return plan;
    }

    stimuli::Study study_ = small_study(3);
    base::Random random_;
    double now_s_ = 0.0;
    tests::TemporaryFolder folder_;
    std::string url_ = "sqlite3://" + (folder_ / "killed.sqlite").string();
};

TEST(KilledSessions, AskEveryQuestionOnceAndLoseNoAnswerIn200Kills) {
    int kills = 0;
    for (std::uint64_t seed = 1; kills < 200; ++seed) {
        KilledSession session(seed);
        kills += session.run();
        analysis::Store store = session.store();
        ASSERT_THAT(store.trials(), SizeIs(3));
        EXPECT_EQ(store.sessions().at(0).state, analysis::SessionState::kCompleted);
        // Of each pair: the choice, confidence, and a rating of either image; none twice.
        const auto answers = analysis::answers_among(store.events());
        std::map<int, std::vector<std::string>> asked;
        for (const QuestionAnswer& answer : answers) {
            asked[answer.trial_index].push_back(answer.question + ' ' + answer.about);
        }
        ASSERT_THAT(asked, SizeIs(3));
        for (const auto& [trial, questions] : asked) {
            EXPECT_THAT(questions, testing::UnorderedElementsAre("real pair", "sure pair", "like A",
                                                                 "like B"));
        }
        // A choice is that of its trial, or a coin's.
        const auto trials = store.trials();
        for (const QuestionAnswer& answer : answers) {
            if (answer.question != "real" || answer.answer == "none") continue;
            const TrialRecord& trial = trials.at(static_cast<std::size_t>(answer.trial_index));
            EXPECT_EQ(answer.answer, trial.is_A_selected ? "A" : "B");
        }
    }
}

}  // namespace
}  // namespace obscura::app::kiosk
