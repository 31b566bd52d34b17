// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/store.h"

#include <algorithm>
#include <string_view>

#include "analysis/store/backup.h"
#include "analysis/store/checks.h"
#include "analysis/store/columns.h"
#include "analysis/store/merge.h"
#include "analysis/store/schema.h"
#include "analysis/store/store_impl.h"

namespace obscura::analysis {
namespace {

/// The session of that id. Throws failure when there is none.
SessionRecord find_session(Database& database, const std::string& session_id) {
    auto found =
        select(database.session(), sessions_table(), "WHERE session_id = :id", {session_id});
    if (found.empty()) {
        throw base::failure("the store {} has no session {}", database.name(), session_id);
    }
    return found.front();
}

SessionRecord find_open_session(Database& database, const std::string& session_id) {
    SessionRecord session = find_session(database, session_id);
    if (session.state != SessionState::kOpen) {
        throw base::failure("session {} in the store {} is {}, allowed is open", session_id,
                            database.name(), to_string(session.state));
    }
    return session;
}

/// Trials that count towards condition_count: all but practice.
int count_answers(Database& database, const SessionRecord& session) {
    int count = 0;
    database.session()
        << "SELECT COUNT(*) FROM trials WHERE session_id = :id AND kind <> 'practice'",
        soci::use(session.session_id), soci::into(count);
    return count;
}

void refuse_taken_names(Database& database, const SessionRecord& session) {
    int count = 0;
    database.session() << "SELECT COUNT(*) FROM participants WHERE participant_id = :id",
        soci::use(session.participant_id), soci::into(count);
    if (count > 0) {
        throw base::failure("participant {} is already in the store {}", session.participant_id,
                            database.name());
    }
    database.session() << "SELECT COUNT(*) FROM sessions WHERE session_id = :id",
        soci::use(session.session_id), soci::into(count);
    if (count > 0) {
        throw base::failure("session {} is already in the store {}", session.session_id,
                            database.name());
    }
}

void refuse_taken_slot(Database& database, const SessionRecord& session) {
    const std::string kind(to_string(session.kind));
    const auto seed = static_cast<long long>(session.seed);
    const auto slot = static_cast<long long>(session.slot);
    std::string holder;
    soci::indicator indicator = soci::i_null;
    database.session() << "SELECT session_id FROM sessions WHERE study = :study AND seed = :seed "
                          "AND kind = :kind AND slot = :slot AND state <> 'abandoned'",
        soci::use(session.study), soci::use(seed), soci::use(kind), soci::use(slot),
        soci::into(holder, indicator);
    if (database.session().got_data()) {
        throw base::failure(
            "slot {} of the order of study {} (seed {}, {}) is taken by session {} in the store {}",
            session.slot, session.study, session.seed, kind, holder, database.name());
    }
}

void refuse_answered(Database& database, const TrialRecord& trial) {
    const auto answered =
        select(database.session(), trials_table(), "WHERE session_id = :id", {trial.session_id});
    for (const TrialRecord& other : answered) {
        if (other.trial_index == trial.trial_index) {
            throw base::failure("trial {} of session {} is already answered in the store {}",
                                trial.trial_index, trial.session_id, database.name());
        }
        const bool either_practice = other.kind == Kind::kPractice || trial.kind == Kind::kPractice;
        if (!either_practice && other.condition == trial.condition) {
            throw base::failure(
                "condition {} of session {} is already answered (trial {}) in the store {}",
                trial.condition, trial.session_id, other.trial_index, database.name());
        }
    }
}

void refuse_other_kind(const TrialRecord& trial, const SessionRecord& session) {
    const bool aside = trial.kind == Kind::kPractice || trial.kind == Kind::kCatch;
    if (!aside && trial.kind != session.kind) {
        throw base::bad_input("trial {} of session {}: kind is {}, but the session's is {}",
                              trial.trial_index, trial.session_id, to_string(trial.kind),
                              to_string(session.kind));
    }
}

void set_state(Database& database, const std::string& session_id, SessionState state,
               const std::string& ended_utc) {
    const std::string name(to_string(state));
    database.session() << "UPDATE sessions SET state = :state, ended_utc = :ended "
                          "WHERE session_id = :id",
        soci::use(name), soci::use(ended_utc), soci::use(session_id);
}

}  // namespace

Store::Store(const std::string& url, Access access) : impl_(std::make_unique<Impl>(url, access)) {
    Database& database = impl_->database;
    database.guarded("open", [&] {
        if (access == Access::kReadOnly) {
            database.require_whole_beside();
            require_current(database, migrations());
            return;
        }
        database.require_whole();
        if (access == Access::kThrowaway) database.do_not_wait_for_the_disk();
        migrate(database, migrations());
        database.keep_in_one_file();
    });
}

void Store::require_whole() {
    impl_->database.guarded("read", [&] { impl_->database.await_check(); });
}

void Store::require_in_place() { impl_->database.require_in_place(); }

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

std::uint64_t Store::begin_session(const ParticipantRecord& participant,
                                   const SessionRecord& session,
                                   const std::vector<EventRecord>& events,
                                   const MoveSession& move) {
    check(participant);
    check(session);
    for (const EventRecord& event : events) check(event);
    if (session.participant_id != participant.participant_id || session.kind != participant.kind) {
        throw base::bad_input("session {} is of the {} {}, but the participant given is the {} {}",
                              session.session_id, to_string(session.kind), session.participant_id,
                              to_string(participant.kind), participant.participant_id);
    }
    std::uint64_t slot = session.slot;
    impl_->change("begin a session in", [&] {
        Database& database = impl_->database;
        refuse_taken_names(database, session);
        SessionRecord placed = session;
        if (move) {
            const auto taken = slots_taken(database, session.study, session.seed, session.kind);
            if (std::find(taken.begin(), taken.end(), placed.slot) != taken.end()) {
                move(placed, taken);
                check(placed);
            }
        }
        refuse_taken_slot(database, placed);
        insert(database.session(), participants_table(), participant);
        insert(database.session(), sessions_table(), placed);
        insert(database.session(), events_table(),
               EventRecord{session.session_id, session.started_utc, "session started", ""});
        for (const EventRecord& event : events) insert(database.session(), events_table(), event);
        slot = placed.slot;
    });
    return slot;
}

void Store::add_trial(const TrialRecord& trial) {
    check(trial);
    impl_->change("write an answer to", [&] {
        Database& database = impl_->database;
        const SessionRecord session = find_open_session(database, trial.session_id);
        refuse_other_kind(trial, session);
        refuse_answered(database, trial);
        if (trial.kind != Kind::kPractice &&
            count_answers(database, session) >= session.condition_count) {
            throw base::failure("session {} already has all its {} answers in the store {}",
                                session.session_id, session.condition_count, database.name());
        }
        insert(database.session(), trials_table(), trial);
    });
}

void Store::add_event(const EventRecord& event) {
    check(event);
    impl_->change("write an event to", [&] {
        if (!event.session_id.empty()) (void)find_session(impl_->database, event.session_id);
        insert(impl_->database.session(), events_table(), event);
    });
}

void Store::complete_session(const std::string& session_id, const std::string& ended_utc) {
    check_utc("session " + session_id, "ended_utc", ended_utc);
    impl_->change("complete a session in", [&] {
        const SessionRecord session = find_open_session(impl_->database, session_id);
        const int answers = count_answers(impl_->database, session);
        if (answers != session.condition_count) {
            throw base::failure("session {} in the store {} has {} answers, complete are {}",
                                session_id, impl_->database.name(), answers,
                                session.condition_count);
        }
        set_state(impl_->database, session_id, SessionState::kCompleted, ended_utc);
    });
}

void Store::abandon_session(const std::string& session_id, const std::string& ended_utc,
                            const std::string& reason) {
    const EventRecord event{session_id, ended_utc, "session abandoned", reason};
    check(event);
    impl_->change("abandon a session in", [&] {
        (void)find_open_session(impl_->database, session_id);
        set_state(impl_->database, session_id, SessionState::kAbandoned, ended_utc);
        insert(impl_->database.session(), events_table(), event);
    });
}

MergedRows Store::take_in(Store& other) {
    StoreRows rows;
    other.of_one_moment([&] {
        rows = {other.impl_->database.name(), other.participants(), other.sessions(),
                other.trials(), other.events()};
    });
    MergedRows merged;
    impl_->change("merge into", [&] { merged = merge(impl_->database, rows); });
    return merged;
}

std::optional<std::filesystem::path> Store::back_up(const std::filesystem::path& folder,
                                                    const std::string& utc, std::size_t keep) {
    Database& database = impl_->database;
    if (database.system() != Database::System::kSqlite) return std::nullopt;
    return database.guarded("back up",
                            [&] { return analysis::back_up(database, folder, utc, keep); });
}

}  // namespace obscura::analysis
