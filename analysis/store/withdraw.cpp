// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/withdraw.h"

#include <fmt/format.h>

#include "analysis/store/columns.h"
#include "analysis/store/database.h"
#include "analysis/store/records.h"
#include "analysis/store/rows.h"

namespace obscura::analysis {
namespace {

int erase(Database& database, const std::string& table, const std::string& session_id) {
    int count = 0;
    database.session() << "SELECT COUNT(*) FROM " + table + " WHERE session_id = :id",
        soci::use(session_id), soci::into(count);
    database.session() << "DELETE FROM " + table + " WHERE session_id = :id", soci::use(session_id);
    return count;
}

WithdrawnRows withdraw(Database& database, const std::string& participant_id,
                       const std::string& utc) {
    const auto sessions = select(database.session(), sessions_table(), "WHERE participant_id = :id",
                                 {participant_id});
    if (sessions.empty()) {
        throw base::failure("the store {} has no participant {}", database.name(), participant_id);
    }
    WithdrawnRows erased;
    for (const SessionRecord& session : sessions) {
        if (session.state == SessionState::kOpen) {
            throw base::failure("session {} in the store {} is open: close it first",
                                session.session_id, database.name());
        }
        erased.trials += erase(database, "trials", session.session_id);
        erased.events += erase(database, "events", session.session_id);
        erased.sessions += erase(database, "sessions", session.session_id);
    }
    database.session() << "DELETE FROM participants WHERE participant_id = :id",
        soci::use(participant_id);
    insert(database.session(), events_table(),
           EventRecord{"", utc, "participant withdrawn",
                       fmt::format("{} sessions, {} answers and {} events erased", erased.sessions,
                                   erased.trials, erased.events)});
    return erased;
}

}  // namespace

WithdrawnRows withdraw_participant(const std::string& store_url, const std::string& participant_id,
                                   const std::string& utc) {
    Database database(store_url, false);
    WithdrawnRows erased;
    database.guarded("withdraw a participant from", [&] {
        Transaction transaction(database);
        erased = withdraw(database, participant_id, utc);
        transaction.commit();
    });
    return erased;
}

}  // namespace obscura::analysis
