// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/spool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/kiosk/recording.h"
#include "tests/app/kiosk/script.h"
#include "tests/support/postgres.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using analysis::SessionState;
using analysis::Store;
using testing::ElementsAre;

/// A session on a server that goes away and comes back.
class SpoolTest : public testing::Test {
  protected:
    SpoolTest() { plan_.order = study_.session_order(0); }

    /// Plays on from pair `from` up to before `to`; t is the time.
    void answer(Script& script, int from, int to) {
        for (int pair = from; pair < to; ++pair) script.answer_pair(20.0 + 20.0 * pair, pair, true);
    }
    /// Rows of the script as a journal takes them; gives what could not be saved.
    std::optional<std::string> flush(Journal& journal, Script& script) {
        journal.add(std::exchange(script.rows, {}));
        return journal.flush();
    }

    tests::TemporaryFolder folder_;
    tests::PostgresServer& server_ = tests::PostgresServer::shared();
    std::string url_ = server_.new_database();
    stimuli::Study study_ = small_study(4);
    SessionPlan plan_ = small_plan(study_);
};

/// Times as records want them: the script's are short.
void settle_times(std::vector<Row>& rows) {
    const std::string utc = "2026-11-26T10:00:00Z";
    for (Row& row : rows) {
        if (auto* begin = std::get_if<BeginSession>(&row)) {
            begin->participant.created_utc = begin->session.started_utc = utc;
            for (auto& event : begin->events) event.time_utc = utc;
        }
        if (auto* trial = std::get_if<analysis::TrialRecord>(&row)) trial->answered_utc = utc;
        if (auto* end = std::get_if<CompleteSession>(&row)) end->ended_utc = utc;
        if (auto* event = std::get_if<analysis::EventRecord>(&row)) event->time_utc = utc;
    }
}

TEST_F(SpoolTest, AnswersOfALostServerAreKeptHereAndDeliveredOnceInOrder) {
    Store store(url_, Store::Access::kReadWrite);
    Spool spool(folder_.path(), url_);
    Script script(study_, plan_);
    Journal journal = journal_to(store, study_, script.procedure, spool);
    const auto save = [&] {
        settle_times(script.rows);
        return flush(journal, script);
    };
    script.reach_pairs();
    answer(script, 0, 1);
    EXPECT_EQ(save(), std::nullopt);
    EXPECT_FALSE(spool.waits());
    server_.stop();
    answer(script, 1, 3);
    EXPECT_EQ(save(), std::nullopt) << "nobody is kept waiting";
    EXPECT_TRUE(spool.waits());
    server_.start();
    answer(script, 3, 4);
    EXPECT_EQ(save(), std::nullopt);
    EXPECT_FALSE(spool.waits());
    const auto trials = store.trials_of("s-1");
    ASSERT_EQ(trials.size(), 4U);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(trials[static_cast<std::size_t>(i)].trial_index, i);
    EXPECT_EQ(store.sessions().front().state, SessionState::kCompleted);
}

TEST_F(SpoolTest, WhatIsKeptIsDeliveredAfterTheProgramHasEndedToo) {
    {
        Store store(url_, Store::Access::kReadWrite);
        Spool spool(folder_.path(), url_);
        Script script(study_, plan_);
        Journal journal = journal_to(store, study_, script.procedure, spool);
        script.reach_pairs();
        settle_times(script.rows);
        EXPECT_EQ(flush(journal, script), std::nullopt);
        server_.stop();
        answer(script, 0, 4);
        settle_times(script.rows);
        EXPECT_EQ(flush(journal, script), std::nullopt);
    }
    server_.start();
    Spool spool(folder_.path(), url_);
    ASSERT_TRUE(spool.waits());
    EXPECT_TRUE(spool.is_own("s-1"));
    EXPECT_FALSE(spool.is_own("s-2"));
    EXPECT_FALSE(Spool(folder_.path(), url_ + "other").is_own("s-1")) << "of another server";
    Store store(url_, Store::Access::kReadWrite);
    spool.deliver(store);
    EXPECT_FALSE(spool.waits());
    EXPECT_EQ(store.trials().size(), 4U);
    EXPECT_EQ(store.sessions().front().state, SessionState::kCompleted);
}

TEST_F(SpoolTest, NoSessionBeginsWhileTheServerIsAway) {
    Store store(url_, Store::Access::kReadWrite);
    Spool spool(folder_.path(), url_);
    Script script(study_, plan_);
    Journal journal = journal_to(store, study_, script.procedure, spool);
    script.reach_pairs();
    settle_times(script.rows);
    server_.stop();
    EXPECT_NE(flush(journal, script), std::nullopt);
    EXPECT_FALSE(spool.waits());
    server_.start();
    EXPECT_EQ(journal.flush(), std::nullopt);
    EXPECT_EQ(store.sessions().size(), 1U);
}

}  // namespace
}  // namespace obscura::app::kiosk
