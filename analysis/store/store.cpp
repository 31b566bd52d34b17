// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/store.h"

#include <algorithm>
#include <chrono>
#include <random>
#include <string_view>
#include <thread>

#include "analysis/store/backup.h"
#include "analysis/store/checks.h"
#include "analysis/store/columns.h"
#include "analysis/store/database.h"
#include "analysis/store/merge.h"
#include "analysis/store/rows.h"
#include "analysis/store/schema.h"

namespace obscura::analysis {
namespace {

/// Of a change that meets others: with ten kiosks the third is rare.
constexpr int kMostAttempts = 50;

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

std::vector<std::uint64_t> slots_taken(Database& database, const std::string& study,
                                       std::uint64_t seed, Kind kind) {
    const auto holders =
        select(database.session(), sessions_table(),
               "WHERE state <> 'abandoned' AND study = :study AND kind = :kind ORDER BY slot",
               {study, std::string(to_string(kind))});
    std::vector<std::uint64_t> slots;
    for (const SessionRecord& session : holders) {
        if (session.seed == seed) slots.push_back(session.slot);
    }
    return slots;
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

struct Store::Impl {
    Impl(const std::string& url, Access access) : database(url, access == Access::kReadOnly) {}
    Database database;

    /// `work` in one transaction, its errors in the house's words.
    template <typename Work>
    void change(std::string_view doing, Work&& work) {
        database.guarded(doing, [&] {
            for (int attempt = 1; !changed(work, attempt == kMostAttempts); ++attempt) {
                // Those that met do not meet again at once.
                static thread_local std::minstd_rand random{std::random_device{}()};
                std::uniform_int_distribution<int> wait_ms(1, 5 * attempt);
                std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms(random)));
            }
        });
    }

    /// False: it met another one and is to be tried again.
    template <typename Work>
    bool changed(Work& work, bool last) {
        database.require_in_place();
        try {
            Transaction transaction(database);
            work();
            transaction.commit();
            return true;
        } catch (const soci::soci_error& error) {
            if (last || !Database::asks_to_try_again(error)) throw;
            return false;
        }
    }

    template <typename Record>
    void each(const RecordTable<Record>& table, const std::string& rest,
              const std::function<void(const Record&)>& take) {
        database.guarded("read", [&] {
            Rows<Record> rows(database.session(), table, rest);
            for (Record record; rows.next(record);) take(record);
        });
    }

    template <typename Record>
    std::vector<Record> read(const RecordTable<Record>& table, const std::string& rest,
                             const std::vector<std::string>& values = {}) {
        return database.guarded("read",
                                [&] { return select(database.session(), table, rest, values); });
    }
};

Store::Store(const std::string& url, Access access) : impl_(std::make_unique<Impl>(url, access)) {
    Database& database = impl_->database;
    database.guarded("open", [&] {
        database.require_whole();
        if (access == Access::kReadOnly) {
            require_current(database, migrations());
            return;
        }
        if (access == Access::kThrowaway) database.do_not_wait_for_the_disk();
        migrate(database, migrations());
        database.keep_in_one_file();
    });
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

std::vector<SessionRecord> Store::open_sessions(const std::string& study, Kind kind) {
    return impl_->read(sessions_table(),
                       "WHERE state = 'open' AND study = :study AND kind = :kind ORDER BY entry",
                       {study, std::string(to_string(kind))});
}

std::vector<std::uint64_t> Store::taken_slots(const std::string& study, std::uint64_t seed,
                                              Kind kind) {
    return impl_->database.guarded("read",
                                   [&] { return slots_taken(impl_->database, study, seed, kind); });
}

std::vector<std::string> Store::codes_of(const std::string& study) {
    return impl_->database.guarded("read", [&] {
        const std::string kind(to_string(Kind::kParticipant));
        const soci::rowset<std::string> rows =
            (impl_->database.session().prepare
                 << "SELECT DISTINCT p.code FROM participants p, sessions s WHERE s.participant_id "
                    "= p.participant_id AND p.code IS NOT NULL AND s.study = :study AND s.kind = "
                    ":kind",
             soci::use(study), soci::use(kind));
        return std::vector<std::string>(rows.begin(), rows.end());
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

std::string Store::latest_utc() {
    return impl_->database.guarded(
        "read", [&] {
            std::string latest;
            soci::indicator indicator = soci::i_null;
            impl_->database.session()
                << "SELECT MAX(latest) FROM (SELECT MAX(time_utc) AS latest FROM events UNION ALL "
                   "SELECT MAX(started_utc) FROM sessions UNION ALL SELECT MAX(answered_utc) FROM "
                   "trials) AS times",
                soci::into(latest, indicator);
            return indicator == soci::i_ok ? latest : std::string();
        });
}

std::vector<ParticipantRecord> Store::participants() {
    return impl_->read(participants_table(), "ORDER BY entry");
}

std::vector<SessionRecord> Store::sessions() {
    return impl_->read(sessions_table(), "ORDER BY entry");
}

std::vector<TrialRecord> Store::trials() {
    std::vector<TrialRecord> trials;
    each_trial([&](const TrialRecord& trial, const SessionRecord&) { trials.push_back(trial); });
    return trials;
}

void Store::each_participant(const std::function<void(const ParticipantRecord&)>& take) {
    impl_->each(participants_table(), "participants ORDER BY entry", take);
}

void Store::each_session(const std::function<void(const SessionRecord&)>& take) {
    impl_->each(sessions_table(), "sessions ORDER BY entry", take);
}

void Store::each_session_with_events(
    const std::function<void(const SessionRecord&, const std::vector<EventRecord>&)>& take) {
    of_one_moment([&] {
        impl_->database.guarded("read", [&] {
            soci::session& session = impl_->database.session();
            Rows<SessionRecord> sessions(session, sessions_table(), "sessions ORDER BY entry");
            Rows<EventRecord> events(session, events_table(),
                                     "sessions s CROSS JOIN events e WHERE e.session_id = "
                                     "s.session_id ORDER BY s.entry, e.entry",
                                     {}, "e.");
            EventRecord event;
            bool is_event = events.next(event);
            std::vector<EventRecord> own;
            for (SessionRecord record; sessions.next(record); own.clear()) {
                for (; is_event && event.session_id == record.session_id;
                     is_event = events.next(event)) {
                    own.push_back(event);
                }
                take(record, own);
            }
        });
    });
}

void Store::each_answer(const std::function<void(const SessionRecord&)>& take_session,
                        const std::function<void(const TrialRecord&)>& take_trial) {
    static const auto sessions =
        part_of(sessions_table(), {"session_id", "participant_id", "kind", "study", "study_sha256",
                                   "state", "exclusion", "study_plan"});
    static const auto trials =
        part_of(trials_table(), {"session_id", "kind", "trial_index", "condition", "hypothesis",
                                 "scene", "validity", "condition_A", "condition_B", "first_shown",
                                 "is_A_selected", "response_time_s", "expected", "repeats"});
    of_one_moment([&] {
        impl_->each(sessions, "sessions ORDER BY entry", take_session);
        impl_->each(trials, "trials ORDER BY entry", take_trial);
    });
}

void Store::each_trial(const std::function<void(const TrialRecord&, const SessionRecord&)>& take) {
    of_one_moment([&] {
        impl_->database.guarded("read", [&] {
            // Two rows of statements side by side, so that no session is read once for each trial.
            // CROSS JOIN keeps SQLite from sorting the trials: it finds them session by session.
            soci::session& session = impl_->database.session();
            Rows<SessionRecord> sessions(session, sessions_table(), "sessions ORDER BY entry");
            Rows<TrialRecord> trials(session, trials_table(),
                                     "sessions s CROSS JOIN trials t WHERE t.session_id = "
                                     "s.session_id ORDER BY s.entry, t.trial_index",
                                     {}, "t.");
            SessionRecord of_trial;
            for (TrialRecord trial; trials.next(trial);) {
                while (of_trial.session_id != trial.session_id) {
                    if (!sessions.next(of_trial)) {
                        throw base::failure("the store {} has no session {}",
                                            impl_->database.name(), trial.session_id);
                    }
                }
                take(trial, of_trial);
            }
        });
    });
}

void Store::of_one_moment(const std::function<void()>& work) {
    impl_->database.guarded("read", [&] {
        const ReadTransaction transaction(impl_->database);
        work();
    });
}

std::vector<TrialRecord> Store::trials_of(const std::string& session_id) {
    return impl_->read(trials_table(), "WHERE session_id = :id ORDER BY trial_index", {session_id});
}

std::vector<EventRecord> Store::events() { return impl_->read(events_table(), "ORDER BY entry"); }

std::vector<EventRecord> Store::events_of(const std::string& session_id) {
    return impl_->read(events_table(), "WHERE session_id = :id ORDER BY entry", {session_id});
}

std::vector<EventRecord> Store::other_events() {
    return impl_->read(events_table(), "WHERE session_id IS NULL ORDER BY entry");
}

}  // namespace obscura::analysis
