// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/merge.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "analysis/store/rows.h"

namespace obscura::analysis {
namespace {

template <typename Record>
std::vector<Record> rows_of(Database& database, const RecordTable<Record>& table) {
    return select(database.session(), table, "ORDER BY entry");
}

template <typename Record, typename Key>
auto by(const std::vector<Record>& records, Key Record::*key) {
    std::map<Key, const Record*> found;
    for (const Record& record : records) found[record.*key] = &record;
    return found;
}

/// The hashes under which each study was run.
using StudyHashes = std::map<std::string, std::set<std::string>>;

StudyHashes study_files(const StoreRows& store) {
    StudyHashes hashes;
    for (const SessionRecord& session : store.sessions) {
        hashes[session.study].insert(session.study_sha256);
    }
    return hashes;
}

StudyHashes study_images(const StoreRows& store) {
    const auto sessions = by(store.sessions, &SessionRecord::session_id);
    StudyHashes hashes;
    for (const EventRecord& event : store.events) {
        const auto session = sessions.find(event.session_id);
        if (event.name != kStimuliDigestEvent || session == sessions.end()) continue;
        hashes[session->second->study].insert(event.detail);
    }
    return hashes;
}

void require_same(const StudyHashes& into, const StudyHashes& from, const StoreRows& store,
                  const std::string& there, std::string_view what) {
    for (const auto& [study, hashes] : from) {
        const auto known = into.find(study);
        if (known == into.end()) continue;
        for (const std::string& hash : hashes) {
            if (known->second.contains(hash)) continue;
            throw base::bad_input(
                "{}: the {} of {} ({}...) is not that in {} ({}...): these are not answers to the "
                "same study; nothing was merged",
                store.name, what, study, hash.substr(0, 12), there,
                known->second.begin()->substr(0, 12));
        }
    }
}

[[nodiscard]] base::Error contradicts(const StoreRows& from, const std::string& there,
                                      std::string_view what, const std::string& name) {
    return base::bad_input("{}: {} {} is in {} too, and says something else; nothing was merged",
                           from.name, what, name, there);
}

/// Where a session began is the same in both, however far each has it.
bool is_same_session(SessionRecord one, const SessionRecord& other) {
    one.state = other.state;
    one.ended_utc = other.ended_utc;
    one.slot_copy = other.slot_copy;
    return one == other;
}

/// One merge, of `from_` into what the database holds.
class Merging {
  public:
    Merging(Database& database, const StoreRows& from) : from_(from), session_(database.session()) {
        there_ = {database.name(), rows_of(database, participants_table()),
                  rows_of(database, sessions_table()), rows_of(database, trials_table()),
                  rows_of(database, events_table())};
    }

    MergedRows run() {
        require_same(study_files(there_), study_files(from_), from_, there_.name, "study file");
        require_same(study_images(there_), study_images(from_), from_, there_.name,
                     "digest of the images");
        require_agreement();
        add_participants();
        add_sessions();
        add_trials();
        add_events();
        complete_sessions();
        return merged_;
    }

  private:
    void require_agreement() {
        const auto participants = by(there_.participants, &ParticipantRecord::participant_id);
        for (const ParticipantRecord& participant : from_.participants) {
            const auto known = participants.find(participant.participant_id);
            if (known != participants.end() && *known->second != participant) {
                throw contradicts(from_, there_.name, "participant", participant.participant_id);
            }
        }
        const auto sessions = by(there_.sessions, &SessionRecord::session_id);
        for (const SessionRecord& session : from_.sessions) {
            const auto known = sessions.find(session.session_id);
            if (known != sessions.end() && !is_same_session(*known->second, session)) {
                throw contradicts(from_, there_.name, "session", session.session_id);
            }
        }
        for (const TrialRecord& trial : there_.trials) {
            trials_[{trial.session_id, trial.trial_index}] = &trial;
        }
        for (const TrialRecord& trial : from_.trials) {
            const auto known = trials_.find({trial.session_id, trial.trial_index});
            if (known != trials_.end() && *known->second != trial) {
                throw contradicts(
                    from_, there_.name, "answer",
                    fmt::format("{} of session {}", trial.trial_index + 1, trial.session_id));
            }
        }
    }

    void add_participants() {
        const auto known = by(there_.participants, &ParticipantRecord::participant_id);
        for (const ParticipantRecord& participant : from_.participants) {
            if (known.contains(participant.participant_id)) continue;
            insert(session_, participants_table(), participant);
        }
    }

    void add_sessions() {
        using Slot = std::tuple<std::string, std::uint64_t, Kind, std::uint64_t>;
        std::map<Slot, int> held;
        const auto slot_of = [](const SessionRecord& session) {
            return Slot{session.study, session.seed, session.kind, session.slot};
        };
        for (const SessionRecord& session : there_.sessions) {
            if (session.state == SessionState::kAbandoned) continue;
            int& copies = held[slot_of(session)];
            copies = std::max(copies, session.slot_copy + 1);
        }
        const auto known = by(there_.sessions, &SessionRecord::session_id);
        for (SessionRecord session : from_.sessions) {
            if (known.contains(session.session_id)) {
                ++merged_.sessions_there;
                continue;
            }
            session.slot_copy = 0;
            if (session.state != SessionState::kAbandoned) {
                session.slot_copy = held[slot_of(session)]++;
            }
            if (session.slot_copy > 0) ++merged_.shared_slots;
            insert(session_, sessions_table(), session);
            ++merged_.sessions;
        }
    }

    void add_trials() {
        for (const TrialRecord& trial : from_.trials) {
            if (trials_.contains({trial.session_id, trial.trial_index})) continue;
            insert(session_, trials_table(), trial);
            ++merged_.trials;
        }
    }

    /// Events have no name of their own: of equal ones each store keeps as many as it saw.
    void add_events() {
        using Words = std::tuple<std::string, std::string, std::string, std::string>;
        const auto words_of = [](const EventRecord& event) {
            return Words{event.session_id, event.time_utc, event.name, event.detail};
        };
        std::map<Words, int> known;
        for (const EventRecord& event : there_.events) ++known[words_of(event)];
        for (const EventRecord& event : from_.events) {
            if (known[words_of(event)]-- > 0) continue;
            insert(session_, events_table(), event);
            ++merged_.events;
        }
    }

    /// Of sessions that were open there.
    void complete_sessions() {
        const auto known = by(there_.sessions, &SessionRecord::session_id);
        for (const SessionRecord& session : from_.sessions) {
            const auto found = known.find(session.session_id);
            if (found == known.end() || found->second->state != SessionState::kOpen ||
                session.state == SessionState::kOpen) {
                continue;
            }
            const std::string state(to_string(session.state));
            session_ << "UPDATE sessions SET state = :state, ended_utc = :ended "
                        "WHERE session_id = :id",
                soci::use(state), soci::use(session.ended_utc), soci::use(session.session_id);
        }
    }

    const StoreRows& from_;
    soci::session& session_;
    StoreRows there_;
    std::map<std::pair<std::string, int>, const TrialRecord*> trials_;
    MergedRows merged_;
};

}  // namespace

MergedRows merge(Database& into, const StoreRows& from) { return Merging(into, from).run(); }

}  // namespace obscura::analysis
