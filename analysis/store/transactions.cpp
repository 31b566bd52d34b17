// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The scopes in which a store is changed, or stays as it is.
#include <fmt/format.h>
#include <soci/postgresql/soci-postgresql.h>

#include <cassert>

#include "analysis/store/database.h"

namespace obscura::analysis {
namespace {

/// The lock of Turn, among a database's own: the letters "obsc".
constexpr int kTurnNumber = 0x6f627363;

}  // namespace

Turn::Turn(Database& database) : database_(database) {
    if (database_.system() != Database::System::kPostgresql) return;
    database_.execute("SET lock_timeout = '2s'");
    try {
        database_.execute(fmt::format("SELECT pg_advisory_lock({})", kTurnNumber));
        taken_ = true;
    } catch (const soci::postgresql_soci_error& error) {
        if (error.sqlstate() != "55P03") throw;  // lock_not_available
    }
    database_.execute("SET lock_timeout = 0");
}

Turn::~Turn() {
    if (!taken_) return;
    try {
        database_.execute(fmt::format("SELECT pg_advisory_unlock({})", kTurnNumber));
    } catch (const soci::soci_error&) {
        // The connection is gone, and its locks with it.
    }
}

Transaction::Transaction(Database& database) : database_(database) {
    assert(database.reading_ == nullptr);
    database_.execute(database_.system() == Database::System::kSqlite ? "BEGIN IMMEDIATE"
                                                                      : "BEGIN");
}

Transaction::~Transaction() {
    if (!open_) return;
    try {
        database_.execute("ROLLBACK");
    } catch (const soci::soci_error&) {
        // The database has rolled back by itself, or the connection is gone: either way nothing
        // of this transaction stays.
    }
}

void Transaction::commit() {
    assert(open_);
    database_.execute("COMMIT");
    open_ = false;
}

ReadTransaction::ReadTransaction(Database& database, Moment moment)
    : database_(database), outermost_(database.reading_ == nullptr) {
    if (!outermost_) return;
    const bool sqlite = database_.system() == Database::System::kSqlite;
    if (sqlite && moment == Moment::kCopied) {
        copy_.open(soci::sqlite3, "");
        database_.copy_sqlite_to(copy_);
        database_.reading_ = &copy_;
        return;
    }
    database_.execute(sqlite ? "BEGIN" : "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY");
    database_.reading_ = &database_.session_;
}

ReadTransaction::~ReadTransaction() {
    if (!outermost_) return;
    const bool of_copy = database_.reading_ == &copy_;
    database_.reading_ = nullptr;
    if (of_copy) return;
    try {
        database_.execute("COMMIT");
    } catch (const soci::soci_error&) {
        // Nothing was written; the connection that cannot end it is gone.
    }
}

}  // namespace obscura::analysis
