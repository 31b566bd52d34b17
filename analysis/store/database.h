// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <soci/soci.h>

#include <string>
#include <string_view>
#include <utility>

#include "renderer/base/error.h"

namespace obscura::analysis {

/// One connection through SOCI, and the few places where the two systems differ.
class Database {
  public:
    enum class System { kSqlite, kPostgresql };

    /// `url` is sqlite3://FILE or postgresql://...; a missing SQLite file is made unless read-only.
    /// Throws bad input for another URL, a directory, a file that is no SQLite database, a place
    /// that cannot be written (or, read-only, a file that is missing); such a file stays as it is.
    Database(const std::string& url, bool read_only);

    [[nodiscard]] soci::session& session() { return session_; }
    [[nodiscard]] System system() const { return system_; }
    /// The file, or the server's URL without its password: for messages.
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Runs a statement without values.
    void execute(const std::string& statement) { session_ << statement; }

    /// SQLite: write-ahead log, so that readers and the one writer do not wait for each other.
    void use_write_ahead_log();

    /// Calls `work` and gives SOCI's errors as base::Error that name the store and `doing`: bad
    /// input for what is no store or may not be written, failure for everything else.
    template <typename Work>
    auto guarded(std::string_view doing, Work&& work) {
        try {
            return std::forward<Work>(work)();
        } catch (const soci::soci_error& error) {
            throw translated(doing, error);
        }
    }

  private:
    friend class ReadTransaction;

    [[nodiscard]] base::Error translated(std::string_view doing,
                                         const soci::soci_error& error) const;
    void open_sqlite(const std::string& file, bool read_only);
    void open_postgresql(const std::string& url, bool read_only);

    System system_ = System::kSqlite;
    bool reading_ = false;  ///< a ReadTransaction is open
    std::string name_;
    soci::session session_;
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

/// A scope in which everything that is read is of one moment. Within another such scope it is part
/// of that one.
class ReadTransaction {
  public:
    explicit ReadTransaction(Database& database);
    ~ReadTransaction();
    ReadTransaction(const ReadTransaction&) = delete;
    ReadTransaction& operator=(const ReadTransaction&) = delete;

  private:
    Database& database_;
    bool outermost_;
};

}  // namespace obscura::analysis
