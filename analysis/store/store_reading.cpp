// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/columns.h"
#include "analysis/store/store_impl.h"

namespace obscura::analysis {

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

std::vector<SessionRecord> Store::open_sessions(const std::string& study, Kind kind) {
    return impl_->read(sessions_table(),
                       "WHERE state = 'open' AND study = :study AND kind = :kind ORDER BY entry",
                       {study, std::string(to_string(kind))});
}

std::vector<std::uint64_t> Store::taken_slots(const std::string& study, std::uint64_t seed,
                                              Kind kind) {
    return impl_->database.read([&] { return slots_taken(impl_->database, study, seed, kind); });
}

std::vector<std::string> Store::codes_of(const std::string& study) {
    return impl_->database.read([&] {
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

std::string Store::latest_utc() {
    return impl_->database.read(
        [&] {
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
        impl_->database.read([&] {
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
        impl_->each_ahead(sessions, "sessions ORDER BY entry", take_session);
        impl_->each_ahead(trials, "trials ORDER BY entry", take_trial);
    });
}

void Store::each_trial(const std::function<void(const TrialRecord&, const SessionRecord&)>& take) {
    of_one_moment([&] {
        impl_->database.read([&] {
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

void Store::of_one_moment(const std::function<void()>& work, Moment moment) {
    impl_->database.read([&] {
        const ReadTransaction transaction(impl_->database, moment);
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
