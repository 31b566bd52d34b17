// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What the operator's page stands on: how a study stands, withdrawing a participant, the PIN.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "analysis/store/withdraw.h"
#include "app/kiosk/operator_report.h"
#include "app/kiosk/pin.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "stimuli/study_reader.h"
#include "tests/app/kiosk/asking_study.h"
#include "tests/app/kiosk/script.h"
#include "tests/app/kiosk/small_study.h"
#include "tests/stimuli/attentive_study.h"
#include "tests/support/postgres.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Store;
using testing::HasSubstr;

class OperatorTest : public testing::Test {
  protected:
    void observe(Store& store, int number) {
        SessionPlan plan = small_plan(study_);
        plan.participant_id = fmt::format("p-{}", number);
        plan.session_id = fmt::format("s-{}", number);
        plan.order = study_.session_order(static_cast<std::uint64_t>(number));
        Procedure procedure(study_, plan);
        Journal journal = journal_to(store);
        base::Random random(static_cast<std::uint64_t>(number));
        VirtualClock clock;
        simulate_observer(procedure, choices_from(study_, {}), random, clock, journal);
    }

    stimuli::Study study_ =
        stimuli::read_study(stimuli::attentive_text(), stimuli::test_catalogue()).study;
    tests::TemporaryFolder folder_;
    std::string url_ = "sqlite3://" + (folder_ / "responses.sqlite").string();
};

TEST_F(OperatorTest, TheReportCountsTheSessionsAndWhoComesNext) {
    Store store(url_, Store::Access::kReadWrite);
    const OperatorReport none = operator_report(store, study_);
    EXPECT_EQ(none.completed, 0);
    EXPECT_EQ(none.to_balance, 0U);
    for (int number = 0; number < 3; ++number) observe(store, number);
    const OperatorReport report = operator_report(store, study_);
    EXPECT_EQ(report.completed, 3);
    EXPECT_EQ(report.next.slot, 3U);
    EXPECT_EQ(report.to_balance, 5U) << "four pairs make blocks of eight";
    EXPECT_EQ(report.checks, 3);
    EXPECT_EQ(report.repeats, 3);
    EXPECT_LE(report.checks_right, 3);
    ASSERT_EQ(report.sessions.size(), 3U);
    EXPECT_EQ(report.sessions[0].session_id, "s-2") << "latest first";
    study_.name = "another";
    EXPECT_EQ(operator_report(store, study_).completed, 0);
}

/// Two pairs that count and one of practice.
stimuli::Study study_with_practice() {
    stimuli::Study study = small_study(3);
    study.conditions[2].practice = true;
    study.conditions[2].hypothesis = "";
    return study;
}

TEST(CutOffPage, CountsPairsThatCountAndNoneWhoseQuestionsAreNotAllAnswered) {
    const stimuli::Study study = study_with_practice();
    Script before(study);
    before.reach_pairs();
    const auto session = before.rows_of<BeginSession>().at(0).session;
    const auto answered_of = [&](SessionPlan plan) {
        const CutOffSession shown =
            cut_off_session(study, plan, session, before.rows_of<analysis::TrialRecord>(), {});
        EXPECT_EQ(shown.count, 2);
        return shown.answered;
    };
    EXPECT_EQ(answered_of(small_plan(study)), 0);
    before.answer_pair(20, 0, true);
    EXPECT_EQ(answered_of(small_plan(study)), 0) << "practice does not count";
    before.at(34, WentOn{});
    before.shown_at(35);
    before.answer_pair(40, 0, true);
    EXPECT_EQ(answered_of(small_plan(study)), 1);
    before.answer_pair(60, 1, true);
    EXPECT_EQ(answered_of(small_plan(study)), 2);
    SessionPlan asking = small_plan(study);
    asking.questions = asking_questions();
    EXPECT_EQ(answered_of(asking), 1) << "further questions of the last pair are open";
}

TEST_F(OperatorTest, WhoeverIsWithdrawnIsErasedTheFactIsKeptAndThePlaceIsFree) {
    for (const std::string& url : {url_, tests::PostgresServer::shared().new_database()}) {
        Store store(url, Store::Access::kReadWrite);
        for (int number = 0; number < 2; ++number) observe(store, number);
        const auto others = store.trials_of("s-1");
        const auto erased = analysis::withdraw_participant(url, "p-0", "2026-01-01T00:00:00Z");
        EXPECT_EQ(erased.sessions, 1);
        EXPECT_EQ(erased.trials, 4);
        EXPECT_TRUE(store.trials_of("s-0").empty());
        EXPECT_TRUE(store.events_of("s-0").empty());
        EXPECT_EQ(store.trials_of("s-1"), others);
        ASSERT_EQ(store.participants().size(), 1U);
        EXPECT_EQ(store.participants()[0].participant_id, "p-1");
        EXPECT_EQ(operator_report(store, study_).next.slot, 0U);
        const auto events = store.other_events();
        ASSERT_FALSE(events.empty());
        EXPECT_EQ(events.back().name, "participant withdrawn");
        EXPECT_THAT(events.back().detail, HasSubstr("4 answers"));
        EXPECT_THAT(events.back().detail, testing::Not(HasSubstr("p-0")));
        EXPECT_THROW((void)analysis::withdraw_participant(url, "p-0", "2026-01-01T00:00:00Z"),
                     base::Error);
    }
}

TEST_F(OperatorTest, NobodyIsWithdrawnOutOfAnOpenSession) {
    Store store(url_, Store::Access::kReadWrite);
    Procedure procedure(study_, small_plan(study_));
    const auto at = [](double time_s) { return Moment{time_s, "2026-05-01T12:00:00Z", time_s}; };
    (void)procedure.step(ScreenPresented{}, at(0.0));
    (void)procedure.step(StartPressed{}, at(1.0));
    (void)procedure.step(ScreenPresented{}, at(2.0));
    for (const Row& row :
         procedure.step(FormSubmitted{{.age_years = 30, .consent = true}}, at(3.0))) {
        commit(store, row);
    }
    try {
        (void)analysis::withdraw_participant(url_, "p-1", "2026-01-01T00:00:00Z");
        ADD_FAILURE();
    } catch (const base::Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("session s-1 in the store"));
    }
    EXPECT_EQ(store.participants().size(), 1U);
}

TEST(OperatorPin, OnlyThePinItselfIsItAndTheFileTellsNothing) {
    const tests::TemporaryFolder folder;
    const auto file = pin_file(folder.path());
    set_pin(file, "271828");
    EXPECT_TRUE(is_pin(file, "271828"));
    for (const char* wrong : {"", "2718", "271829", "2718281"}) EXPECT_FALSE(is_pin(file, wrong));
    const std::string kept = base::read_file(file);
    EXPECT_THAT(kept, testing::Not(HasSubstr("271828")));
    namespace fs = std::filesystem;
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    set_pin(file, "271828");
    EXPECT_NE(base::read_file(file), kept) << "salted";
    set_pin(file, "");
    EXPECT_FALSE(fs::exists(file));
}

TEST(OperatorPin, IsOfFourToTwelveDigits) {
    const tests::TemporaryFolder folder;
    for (const char* bad : {"123", "1234567890123", "12a4", " 1234"}) {
        EXPECT_THROW(set_pin(pin_file(folder.path()), bad), base::Error) << bad;
    }
}

TEST(OperatorPin, EachWrongOneMakesTheNextWaitLongerUpToAMinute) {
    EXPECT_EQ(wait_after_wrong_s(0), 0.0);
    EXPECT_EQ(wait_after_wrong_s(1), 1.0);
    EXPECT_EQ(wait_after_wrong_s(3), 4.0);
    EXPECT_EQ(wait_after_wrong_s(1000), 60.0);
}

}  // namespace
}  // namespace obscura::app::kiosk
