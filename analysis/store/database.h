// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include <future>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "analysis/store/moment.h"
#include "renderer/base/error.h"

namespace obscura::analysis {

/// One connection through SOCI, and the few places where the two systems differ.
class Database {
  public:
    enum class System { kSqlite, kPostgresql };

    /// `url` is what store_address() takes; a missing SQLite file is made unless read-only.
    /// Throws bad input for another URL, a directory, a file that is no SQLite database, a place
    /// that cannot be written (or, read-only, a file that is missing); such a file stays as it is.
    Database(const std::string& url, bool read_only);

    [[nodiscard]] soci::session& session() { return reading_ ? *reading_ : session_; }
    [[nodiscard]] System system() const { return system_; }
    /// The file, or the server's URL without its password: for messages.
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Runs a statement without values.
    void execute(const std::string& statement) { session() << statement; }

    /// PostgreSQL: two transactions met, and this one, of which nothing stays, is to begin anew.
    [[nodiscard]] static bool asks_to_try_again(const soci::soci_error& error);

    /// SQLite: after a commit everything is in the one file (rollback journal, deleted with each
    /// commit); a write-ahead log of an earlier version is folded in.
    void keep_in_one_file();
    /// SQLite: a commit does not wait for the disk.
    void do_not_wait_for_the_disk();
    /// SQLite: throws bad input when a page of the database is damaged. Reads all of it: 3 s for a
    /// million answers.
    void require_whole();
    /// The same of what is only read. Of a large store it is found out beside the reading, on
    /// another connection and core: each read() waits for the finding before what it read counts.
    void require_whole_beside();
    /// Waits for that check, where one runs, and throws the damage.
    void await_check();
    /// SQLite: writes all that it holds at this moment to a new file, also while others read.
    void copy_to(const std::string& file);
    /// SQLite: throws failure when the file was moved, deleted or replaced since it was opened.
    void require_in_place();

    /// Calls `work` and gives SOCI's errors as base::Error that name the store and `doing`: bad
    /// input for what is no store or may not be written, failure for everything else.
    template <typename Work>
    auto guarded(std::string_view doing, Work&& work) {
        try {
            take_up_connection();
            return std::forward<Work>(work)();
        } catch (const soci::soci_error& error) {
            throw translated(doing, error);
        }
    }

    /// guarded() for what reads: it ends when the store is known to be whole, but within a moment,
    /// whose own end waits.
    template <typename Work>
    auto read(Work&& work) {
        return guarded("read", [&] {
            if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
                work();
                if (reading_ == nullptr) await_check();
            } else {
                auto result = work();
                if (reading_ == nullptr) await_check();
                return result;
            }
        });
    }

  private:
    friend class ReadTransaction;
    friend class Transaction;
    friend class Turn;

    [[nodiscard]] base::Error translated(std::string_view doing,
                                         const soci::soci_error& error) const;
    [[nodiscard]] base::Error translated_of_server(std::string_view doing,
                                                   const soci::soci_error& error) const;
    [[nodiscard]] base::Error damaged(std::string_view doing, std::string_view reason) const;
    [[nodiscard]] bool is_large() const;
    void require_ok(const std::string& finding) const;
    [[nodiscard]] sqlite_api::sqlite3* sqlite();
    /// PostgreSQL: connects anew where the server had gone.
    void take_up_connection();
    void settle_connection();
    void copy_sqlite_to(soci::session& copy);
    void open_sqlite(const std::string& file, bool read_only);
    void open_postgresql(const std::string& connection, bool read_only);

    System system_ = System::kSqlite;
    std::string name_;
    bool read_only_ = false;
    bool connected_ = false;  ///< has been; to a server
    soci::session session_;
    std::string uri_;                 ///< of the SQLite file
    std::future<std::string> check_;  ///< of its pages, where one runs beside: "ok", or the damage
    soci::session* reading_ = nullptr;  ///< what the ReadTransaction that is open reads
};

/// PostgreSQL: a scope in which no other kiosk changes the store, so that transactions seldom meet
/// and each has its turn; it ends with the connection too. Who has waited for two seconds goes on
/// without: what meets then is told to try again. SQLite has its own lock, of a transaction.
class Turn {
  public:
    explicit Turn(Database& database);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

  private:
    Database& database_;
    bool taken_ = false;
};

/// A write transaction as a scope: rolled back unless committed. On SQLite it takes the write lock
/// at once (BEGIN IMMEDIATE), so that what it reads stays true until it commits.
class Transaction {
  public:
    explicit Transaction(Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    /// Once, when it returns the changes are on the disk. A second call is a programming error.
    void commit();

  private:
    Database& database_;
    bool open_ = true;
};

/// A scope in which everything that is read is of one moment, and nothing is written. Within
/// another such scope it is part of that one. A reader of an SQLite store keeps its writer waiting
/// for as long as it reads; of a copy, a temporary file that nobody else sees, only while that is
/// made.
class ReadTransaction {
  public:
    ReadTransaction(Database& database, Moment moment);
    ~ReadTransaction();
    ReadTransaction(const ReadTransaction&) = delete;
    ReadTransaction& operator=(const ReadTransaction&) = delete;

  private:
    Database& database_;
    bool outermost_;
    soci::session copy_;
};

}  // namespace obscura::analysis
