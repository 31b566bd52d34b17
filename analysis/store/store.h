// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/store/merged_rows.h"
#include "analysis/store/moment.h"
#include "analysis/store/records.h"

namespace obscura::analysis {

/// The response store: participants, sessions, trials, events in SQLite (or PostgreSQL) through
/// SOCI. Every change is one transaction that is on the disk when the call returns, and in SQLite's
/// one file: a plain copy of it made between two calls holds everything. A call that throws has
/// changed nothing. Errors are base::Error: bad input for a URL or file that is no such store, a
/// damaged file, a newer schema or a read-only place, and for a record with a value that is not
/// allowed; failure for a full disk, for a file that was moved, deleted or replaced meanwhile, and
/// for what the store's state forbids (a slot that is taken, a session that is not open, an index
/// already answered).
///
/// A change waits for programs that are reading the SQLite file, up to 10 s.
/// A store is used by one thread at a time.
class Store {
  public:
    enum class Access {
        kReadWrite,  ///< opens or makes the store, migrates an older schema
        kReadOnly,   ///< must exist with the current schema; is not changed
        kThrowaway,  ///< as kReadWrite, but a change does not wait for the disk: a store that is
                     ///< thrown away where the program does not come to its end
    };

    /// `url` is what store_address() takes: sqlite3://FILE, postgresql://...
    Store(const std::string& url, Access access);
    ~Store();
    Store(Store&&) noexcept;
    Store& operator=(Store&&) noexcept;

    /// Both rows, the event `session started` and `events` of the session, in one transaction.
    /// Refuses a participant or session already there, and a slot that an open or completed session
    /// of the same study, seed and kind holds, also one that another process has just begun.
    ///
    /// Where a slot is taken by then and `move` is given, `move` puts the session into another one,
    /// told which are taken: in the same transaction, so that no slot is left out or given twice,
    /// however many programs begin sessions at once. Gives the slot that it has.
    using MoveSession =
        std::function<void(SessionRecord&, const std::vector<std::uint64_t>& taken)>;
    std::uint64_t begin_session(const ParticipantRecord& participant, const SessionRecord& session,
                                const std::vector<EventRecord>& events = {},
                                const MoveSession& move = nullptr);

    /// One answer. Refuses one for a session that is not open, an index or condition already
    /// answered, or an is_A_selected that does not follow. A trial is of the session's kind, or
    /// practice or catch; only practice does not count towards condition_count, and only its
    /// conditions may come again.
    void add_trial(const TrialRecord& trial);
    void add_event(const EventRecord& event);

    /// Marks it completed; refuses unless condition_count trials are there.
    void complete_session(const std::string& session_id, const std::string& ended_utc);
    /// Marks it abandoned, with the reason as an event.
    void abandon_session(const std::string& session_id, const std::string& ended_utc,
                         const std::string& reason);

    /// Sessions of that study and kind still open, oldest first: those that were cut off.
    [[nodiscard]] std::vector<SessionRecord> open_sessions(const std::string& study, Kind kind);
    /// Slots of the order that completed and open sessions of that study, seed and kind hold.
    [[nodiscard]] std::vector<std::uint64_t> taken_slots(const std::string& study,
                                                         std::uint64_t seed, Kind kind);

    /// Codes of the participants of that study, of people only.
    [[nodiscard]] std::vector<std::string> codes_of(const std::string& study);

    /// Adds the rows of another store that this one has not yet, in one transaction: a second time
    /// adds nothing. See merge(), also for what it refuses.
    MergedRows take_in(Store& other);

    /// Writes a copy of an SQLite store to FOLDER/NAME-TIME.sqlite, on the disk and read back whole
    /// when this returns, and deletes the oldest of more than `keep` such copies. `utc` is a time
    /// as records carry it. Gives the file; nothing for a store on a server, whose owner backs it
    /// up. Throws failure, and leaves the older copies, where that cannot be.
    std::optional<std::filesystem::path> back_up(const std::filesystem::path& folder,
                                                 const std::string& utc, std::size_t keep);

    /// The latest time in any row; empty: there is none.
    [[nodiscard]] std::string latest_utc();

    /// Throws failure when the SQLite file was moved, deleted or replaced since it was opened;
    /// every change asks this too.
    void require_in_place();

    [[nodiscard]] std::vector<ParticipantRecord> participants();
    [[nodiscard]] std::vector<SessionRecord> sessions();
    /// By session, then trial_index.
    [[nodiscard]] std::vector<TrialRecord> trials();
    [[nodiscard]] std::vector<TrialRecord> trials_of(const std::string& session_id);
    [[nodiscard]] std::vector<EventRecord> events();
    [[nodiscard]] std::vector<EventRecord> events_of(const std::string& session_id);
    /// Events that are of no session.
    [[nodiscard]] std::vector<EventRecord> other_events();

    /// The same, a row at a time and in the same order: a million trials need no memory. What
    /// `take` throws ends the reading and goes on to the caller. A record is the callee's for the
    /// call only; it may read the store, not write it.
    void each_participant(const std::function<void(const ParticipantRecord&)>& take);
    void each_session(const std::function<void(const SessionRecord&)>& take);
    /// Each session with its events, of one moment.
    void each_session_with_events(
        const std::function<void(const SessionRecord&, const std::vector<EventRecord>&)>& take);
    /// Each trial with its session, of one moment.
    void each_trial(const std::function<void(const TrialRecord&, const SessionRecord&)>& take);
    /// Sessions, then trials, in order of their rows and with only what an analysis counts: the
    /// other members keep their defaults. Half the cost of each_trial.
    void each_answer(const std::function<void(const SessionRecord&)>& take_session,
                     const std::function<void(const TrialRecord&)>& take_trial);
    /// All that `work` reads is what the store held at one moment, also while a kiosk is writing.
    /// Calls within `work` join in.
    void of_one_moment(const std::function<void()>& work, Moment moment = Moment::kCopied);
    /// Throws bad input when a page is damaged. Every reading ends with it; who keeps something
    /// within a moment asks for it before.
    void require_whole();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace obscura::analysis
