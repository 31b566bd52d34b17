// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/store.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "renderer/base/error.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/postgres.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

using base::ExitCode;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::a_participant;
using tests::a_session;
using tests::a_trial;
using tests::kUtc;

/// The code and the message of the error that `work` ends with.
struct Refusal {
    ExitCode code = ExitCode::kDone;
    std::string message;
};

Refusal refusal_of_store(const std::function<void()>& work) {
    try {
        work();
    } catch (const base::Error& error) {
        return {error.code(), error.what()};
    }
    return {};
}

/// Of a store in an SQLite file and of one on a PostgreSQL server.
class StoreTest : public testing::TestWithParam<const char*> {
  protected:
    Store open(Store::Access access = Store::Access::kReadWrite) { return {url, access}; }

    /// Expects that `work` is refused with that code and text, and that the store stays as it was.
    void expect_refused(Store& store, ExitCode code, const std::string& text,
                        const std::function<void()>& work) {
        const auto participants = store.participants();
        const auto sessions = store.sessions();
        const auto trials = store.trials();
        const auto events = store.events();
        const Refusal refusal = refusal_of_store(work);
        EXPECT_EQ(refusal.code, code) << refusal.message;
        EXPECT_THAT(refusal.message, HasSubstr(text));
        EXPECT_EQ(store.participants(), participants);
        EXPECT_EQ(store.sessions(), sessions);
        EXPECT_EQ(store.trials(), trials);
        EXPECT_EQ(store.events(), events);
    }

    tests::TemporaryFolder folder;
    std::string url =
        GetParam() == std::string("SQLite")
            ? "sqlite3://" + (folder / "with blank, 100% \"quoted\"" / "responses.sqlite").string()
            : tests::PostgresServer::shared().new_database();
};

INSTANTIATE_TEST_SUITE_P(Both, StoreTest, testing::Values("SQLite", "PostgreSQL"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(StoreTest, GivesBackEveryFieldAsItWasWritten) {
    auto participant = a_participant(0);
    participant.gender = "kvinde; ÆØÅ æøå, \"quoted\", it's\nof two lines; DROP TABLE trials";
    participant.normal_vision.reset();
    participant.age_years.reset();
    auto session = a_session(0);
    session.seed = std::numeric_limits<std::int64_t>::max();
    session.refresh_hz = 59.94005994005994;
    auto trial = a_trial(0, 0);
    trial.first_shown = 'B';
    trial.response_first = true;
    trial.is_A_selected = false;
    {
        Store store = open();
        store.begin_session(participant, session);
        store.add_trial(trial);
        store.add_event({"", kUtc, "program started", "no session yet"});
    }
    Store store = open(Store::Access::kReadOnly);
    EXPECT_THAT(store.participants(), ElementsAre(participant));
    EXPECT_THAT(store.sessions(), ElementsAre(session));
    EXPECT_THAT(store.trials(), ElementsAre(trial));
    EXPECT_THAT(store.trials_of("s0"), ElementsAre(trial));
    EXPECT_THAT(store.trials_of("s1"), IsEmpty());
    EXPECT_THAT(store.events(),
                ElementsAre(EventRecord{"s0", kUtc, "session started", ""},
                            EventRecord{"", kUtc, "program started", "no session yet"}));
}

TEST_P(StoreTest, KeepsDoublesBitForBit) {
    Store store = open();
    store.begin_session(a_participant(0), a_session(0));
    const std::vector<double> values{0.1,
                                     1.0 / 3.0,
                                     std::numbers::pi,
                                     std::numeric_limits<double>::denorm_min(),
                                     std::nextafter(2000.0, 3000.0),
                                     123456789.12345678,
                                     0.0};
    for (int index = 0; index < static_cast<int>(values.size()); ++index) {
        auto trial = a_trial(0, index);
        trial.response_time_s = trial.grey_ms_measured = values[static_cast<std::size_t>(index)];
        store.add_trial(trial);
    }
    const auto trials = store.trials();
    ASSERT_EQ(trials.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(trials[i].response_time_s, values[i]);
        EXPECT_EQ(trials[i].grey_ms_measured, values[i]);
    }
}

TEST_P(StoreTest, ASessionIsCompletedOnlyWithAllItsAnswers) {
    Store store = open();
    store.begin_session(a_participant(0), a_session(0));
    for (int index = 0; index < 6; ++index) store.add_trial(a_trial(0, index));
    auto practice = a_trial(0, 90);
    practice.kind = Kind::kPractice;
    store.add_trial(practice);
    expect_refused(store, ExitCode::kFailed, "has 6 answers, complete are 7",
                   [&] { store.complete_session("s0", kUtc); });
    store.add_trial(a_trial(0, 6));
    store.complete_session("s0", kUtc);
    EXPECT_EQ(store.sessions().front().state, SessionState::kCompleted);
    EXPECT_EQ(store.sessions().front().ended_utc, kUtc);
    expect_refused(store, ExitCode::kFailed, "is completed, allowed is open",
                   [&] { store.complete_session("s0", kUtc); });
    expect_refused(store, ExitCode::kFailed, "is completed, allowed is open",
                   [&] { store.add_trial(a_trial(0, 7)); });
}

TEST_P(StoreTest, OnlyOpenAndCompletedSessionsHoldTheirSlot) {
    Store store = open();
    tests::add_completed(store, 0);
    store.begin_session(a_participant(1), a_session(1));
    store.begin_session(a_participant(2), a_session(2));
    store.abandon_session("s1", kUtc, "the operator closed it");
    EXPECT_THAT(store.taken_slots("jakobsen2010", 20100501, Kind::kParticipant), ElementsAre(0, 2));
    EXPECT_THAT(store.taken_slots("jakobsen2010", 1, Kind::kParticipant), IsEmpty());
    EXPECT_THAT(store.taken_slots("jakobsen2010", 20100501, Kind::kSimulated), IsEmpty());
    EXPECT_THAT(store.open_sessions("jakobsen2010", Kind::kParticipant), ElementsAre(a_session(2)));
    EXPECT_THAT(store.open_sessions("other", Kind::kParticipant), IsEmpty());
    EXPECT_EQ(store.events().back(),
              (EventRecord{"s1", kUtc, "session abandoned", "the operator closed it"}));

    auto next = a_session(3);
    next.slot = 1;
    store.begin_session(a_participant(3), next);
    EXPECT_THAT(store.taken_slots("jakobsen2010", 20100501, Kind::kParticipant),
                ElementsAre(0, 1, 2));
}

TEST_P(StoreTest, RefusesASlotThatIsTaken) {
    Store store = open();
    store.begin_session(a_participant(0), a_session(0));
    auto session = a_session(1);
    session.slot = 0;
    expect_refused(store, ExitCode::kFailed, "slot 0 of the order of study jakobsen2010",
                   [&] { store.begin_session(a_participant(1), session); });
    auto participant = a_participant(1);
    participant.kind = session.kind = Kind::kSimulated;
    store.begin_session(participant, session);  // of another kind: its own order
}

TEST_P(StoreTest, RefusesNamesThatAreThere) {
    Store store = open();
    store.begin_session(a_participant(0), a_session(0));
    expect_refused(store, ExitCode::kFailed, "participant p0 is already in the store",
                   [&] { store.begin_session(a_participant(0), a_session(0)); });
    auto session = a_session(1);
    session.session_id = "s0";
    expect_refused(store, ExitCode::kFailed, "session s0 is already in the store",
                   [&] { store.begin_session(a_participant(1), session); });
}

TEST_P(StoreTest, RefusesAnAnswerGivenTwiceOrToNoSession) {
    Store store = open();
    store.begin_session(a_participant(0), a_session(0));
    store.add_trial(a_trial(0, 0));
    expect_refused(store, ExitCode::kFailed, "trial 0 of session s0 is already answered",
                   [&] { store.add_trial(a_trial(0, 0)); });
    auto again = a_trial(0, 1);
    again.condition = "C0";
    expect_refused(store, ExitCode::kFailed, "condition C0 of session s0 is already answered",
                   [&] { store.add_trial(again); });
    expect_refused(store, ExitCode::kFailed, "has no session s9",
                   [&] { store.add_trial(a_trial(9, 0)); });
    expect_refused(store, ExitCode::kFailed, "has no session s9",
                   [&] { store.complete_session("s9", kUtc); });
    expect_refused(store, ExitCode::kFailed, "has no session s9",
                   [&] { store.abandon_session("s9", kUtc, ""); });
    expect_refused(store, ExitCode::kFailed, "has no session s9", [&] {
        store.add_event({"s9", kUtc, "resumed", ""});
    });
}

TEST_P(StoreTest, RefusesMoreAnswersThanTheSessionHasConditions) {
    Store store = open();
    auto session = a_session(0);
    session.condition_count = 1;
    store.begin_session(a_participant(0), session);
    store.add_trial(a_trial(0, 0));
    expect_refused(store, ExitCode::kFailed, "already has all its 1 answers",
                   [&] { store.add_trial(a_trial(0, 1)); });
}

TEST_P(StoreTest, RefusesTrialsWithValuesThatCannotBe) {
    Store store = open();
    store.begin_session(a_participant(0), a_session(0));
    const auto refused = [&](const std::string& text,
                             const std::function<void(TrialRecord&)>& spoil) {
        TrialRecord trial = a_trial(0, 0);
        spoil(trial);
        expect_refused(store, ExitCode::kBadInput, text, [&] { store.add_trial(trial); });
    };
    refused("is_A_selected is true, but A was shown first and the image shown second was chosen",
            [](TrialRecord& trial) { trial.is_A_selected = true; });
    refused("first_shown is code 67, allowed is A or B",
            [](TrialRecord& trial) { trial.first_shown = 'C'; });
    refused("response_time_s is nan",
            [](TrialRecord& trial) { trial.response_time_s = std::nan(""); });
    refused("first_view_ms is inf", [](TrialRecord& trial) {
        trial.first_view_ms = std::numeric_limits<double>::infinity();
    });
    refused("grey_ms_measured is -1", [](TrialRecord& trial) { trial.grey_ms_measured = -1.0; });
    refused("trial_index is -1", [](TrialRecord& trial) { trial.trial_index = -1; });
    refused("dropped_frames is -1", [](TrialRecord& trial) { trial.dropped_frames = -1; });
    refused("hidden_ms is nan", [](TrialRecord& trial) { trial.hidden_ms = std::nan(""); });
    refused("validity is 'lofty', allowed is low, moderate or high",
            [](TrialRecord& trial) { trial.validity = "lofty"; });
    refused("condition is empty", [](TrialRecord& trial) { trial.condition = ""; });
    refused("condition_A is empty", [](TrialRecord& trial) { trial.condition_A = ""; });
    refused("scene is not UTF-8 text", [](TrialRecord& trial) { trial.scene = "atr\xffium"; });
    refused("scene holds a NUL character",
            [](TrialRecord& trial) { trial.scene = std::string("at\0rium", 7); });
    refused("answered_utc is 'yesterday', allowed is UTC",
            [](TrialRecord& trial) { trial.answered_utc = "yesterday"; });
    refused("kind is simulated, but the session's is participant",
            [](TrialRecord& trial) { trial.kind = Kind::kSimulated; });
}

TEST_P(StoreTest, RefusesParticipantsAndSessionsWithValuesThatCannotBe) {
    Store store = open();
    const auto refused = [&](const std::string& text,
                             const std::function<void(ParticipantRecord&, SessionRecord&)>& spoil) {
        ParticipantRecord participant = a_participant(0);
        SessionRecord session = a_session(0);
        spoil(participant, session);
        expect_refused(store, ExitCode::kBadInput, text,
                       [&] { store.begin_session(participant, session); });
    };
    refused("age_years is 0, allowed is 1 to 120", [](auto& p, auto&) { p.age_years = 0; });
    refused("age_years is 121", [](auto& p, auto&) { p.age_years = 121; });
    refused("kind is catch, allowed is participant or simulated",
            [](auto& p, auto&) { p.kind = Kind::kCatch; });
    refused("participant_id is empty", [](auto& p, auto&) { p.participant_id = ""; });
    refused("created_utc is ''", [](auto& p, auto&) { p.created_utc = ""; });
    refused("but the participant given is the participant p0",
            [](auto&, auto& s) { s.participant_id = "p1"; });
    refused("but the participant given is the participant p0",
            [](auto&, auto& s) { s.kind = Kind::kSimulated; });
    refused("condition_count is 0", [](auto&, auto& s) { s.condition_count = 0; });
    refused("latin_row is -1", [](auto&, auto& s) { s.latin_row = -1; });
    refused("seed is 18446744073709551615",
            [](auto&, auto& s) { s.seed = std::numeric_limits<std::uint64_t>::max(); });
    refused("refresh_hz is nan", [](auto&, auto& s) { s.refresh_hz = std::nan(""); });
    refused("begins as completed", [](auto&, auto& s) { s.state = SessionState::kCompleted; });
    refused("study is empty", [](auto&, auto& s) { s.study = ""; });
}

TEST_P(StoreTest, TwoConnectionsSeeEachOthersRowsAndNeverShareASlot) {
    Store one = open();
    Store other = open();
    one.begin_session(a_participant(0), a_session(0));
    auto session = a_session(1);
    session.slot = 0;
    expect_refused(other, ExitCode::kFailed, "is taken by session s0",
                   [&] { other.begin_session(a_participant(1), session); });
    other.add_trial(a_trial(0, 0));
    EXPECT_THAT(one.trials(), ElementsAre(a_trial(0, 0)));
}

TEST_P(StoreTest, KeepsWhatACatchTrialExpectsWhatIsRepeatedAndTheRuleOfExclusion) {
    auto session = a_session(0);
    session.condition_count = 3;
    session.exclusion = R"({"min_catch_correct":0.8})";
    session.study_plan = R"({"sides":"trial"})";
    auto attentive = a_trial(0, 1);
    attentive.kind = Kind::kCatch;
    attentive.expected = 'B';
    auto repeated = a_trial(0, 2);
    repeated.repeats = "C0";
    Store store = open();
    store.begin_session(a_participant(0), session);
    store.add_trial(a_trial(0, 0));
    store.add_trial(attentive);
    expect_refused(store, ExitCode::kFailed, "has 2 answers, complete are 3",
                   [&] { store.complete_session("s0", kUtc); });
    store.add_trial(repeated);
    store.complete_session("s0", kUtc);
    EXPECT_THAT(store.trials(), ElementsAre(a_trial(0, 0), attentive, repeated));
    EXPECT_EQ(store.sessions().front().exclusion, session.exclusion);
    EXPECT_EQ(store.sessions().front().study_plan, session.study_plan);
}

TEST_P(StoreTest, RefusesExpectationsRepeatsAndRulesThatCannotBe) {
    Store store = open();
    auto session = a_session(0);
    session.exclusion = "0.8";
    expect_refused(store, ExitCode::kBadInput, "exclusion is '0.8', allowed is a JSON object",
                   [&] { store.begin_session(a_participant(0), session); });
    session.exclusion = "";
    session.study_plan = "[]";
    expect_refused(store, ExitCode::kBadInput, "study_plan is '[]', allowed is a JSON object",
                   [&] { store.begin_session(a_participant(0), session); });
    store.begin_session(a_participant(0), a_session(0));
    const auto refused = [&](const std::string& text, const auto& spoil) {
        auto trial = a_trial(0, 0);
        spoil(trial);
        expect_refused(store, ExitCode::kBadInput, text, [&] { store.add_trial(trial); });
    };
    refused("expected is code 65, allowed for kind participant is nothing",
            [](auto& t) { t.expected = 'A'; });
    refused("allowed for kind catch is A or B", [](auto& t) { t.kind = Kind::kCatch; });
    refused("repeats is 'C0', the trial's own condition", [](auto& t) { t.repeats = "C0"; });
    refused("repeats is 'C1', allowed for kind practice is nothing", [](auto& t) {
        t.kind = Kind::kPractice;
        t.repeats = "C1";
    });
    auto twice = a_trial(0, 0);
    twice.kind = Kind::kCatch;
    twice.expected = 'A';
    store.add_trial(twice);
    twice.trial_index = 1;
    expect_refused(store, ExitCode::kFailed, "condition C0 of session s0 is already answered",
                   [&] { store.add_trial(twice); });
}

TEST_P(StoreTest, StreamsTheSameRowsInTheSameOrderEachTrialWithItsSession) {
    Store store = open();
    for (const int number : {0, 2, 1}) tests::add_completed(store, number);
    std::vector<TrialRecord> trials;
    store.each_trial([&](const TrialRecord& trial, const SessionRecord& session) {
        EXPECT_EQ(trial.session_id, session.session_id);
        EXPECT_EQ(session.state, SessionState::kCompleted);
        trials.push_back(trial);
    });
    EXPECT_EQ(trials, store.trials());
    EXPECT_EQ(trials.at(7), a_trial(2, 0));
    std::vector<SessionRecord> sessions;
    store.each_session([&](const SessionRecord& session) { sessions.push_back(session); });
    EXPECT_EQ(sessions, store.sessions());
    std::vector<ParticipantRecord> participants;
    store.each_participant([&](const auto& participant) { participants.push_back(participant); });
    EXPECT_EQ(participants, store.participants());
}

TEST_P(StoreTest, WhatIsReadWithinOneMomentDoesNotSeeTheWritesOfAnother) {
    Store store = open();
    tests::add_completed(store, 0);
    Store other = open();
    store.of_one_moment([&] {
        EXPECT_EQ(store.sessions().size(), 1U);
        tests::add_completed(other, 1);
        EXPECT_EQ(store.sessions().size(), 1U);
        EXPECT_EQ(store.trials().size(), 7U);
    });
    EXPECT_EQ(store.sessions().size(), 2U);
    try {
        store.each_trial([](const auto&, const auto&) { throw std::runtime_error("enough"); });
        ADD_FAILURE() << "not passed on";
    } catch (const std::runtime_error&) {
    }
    tests::add_completed(store, 2);
    EXPECT_EQ(store.sessions().size(), 3U);
}

TEST_P(StoreTest, ReadingOnlyRefusesToWrite) {
    { tests::add_completed(*std::make_unique<Store>(open()), 0); }
    Store store = open(Store::Access::kReadOnly);
    expect_refused(store, ExitCode::kBadInput, "it cannot be written there",
                   [&] { store.begin_session(a_participant(1), a_session(1)); });
    EXPECT_EQ(store.trials().size(), 7U);
}

}  // namespace
}  // namespace obscura::analysis
