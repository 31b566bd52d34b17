// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/database.h"

#include <soci/sqlite3/soci-sqlite3.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "renderer/base/files.h"

// Declared here because SOCI's header for PostgreSQL needs libpq's, which nothing else does.
namespace soci {
extern "C" backend_factory const* factory_postgresql();
}

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSqliteScheme = "sqlite3://";
constexpr std::string_view kPostgresqlScheme = "postgresql://";
/// How long a statement waits for another process that is writing.
constexpr int kBusyTimeoutS = 10;
/// The low byte of an extended result code (https://www.sqlite.org/rescode.html).
constexpr int kPrimaryCode = 0xff;

/// First 16 bytes of a database (https://www.sqlite.org/fileformat.html, 1.3.1).
constexpr std::string_view kSqliteMagic{"SQLite format 3\0", 16};

/// No connection is used by two threads at once, so SQLite need not lock one for each value that is
/// read, a fifth of the time of an export (https://www.sqlite.org/threadsafe.html, multi-thread).
void use_connections_without_locks() {
    static const int done = sqlite_api::sqlite3_config(SQLITE_CONFIG_MULTITHREAD);
    (void)done;  // once SQLite is in use it stays as it is, slower and right
}

void require_sqlite_header(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw base::bad_input("cannot open the store {}: {}", file.string(), std::strerror(errno));
    }
    std::array<char, kSqliteMagic.size()> head{};
    stream.read(head.data(), head.size());
    const auto met = static_cast<std::size_t>(stream.gcount());
    if (met != 0 && std::string_view(head.data(), met) != kSqliteMagic) {
        throw base::bad_input("cannot open the store {}: the file is no SQLite database",
                              file.string());
    }
}

void require_writable_file(const fs::path& file, bool exists) {
    base::require_writable_folder(file.parent_path(), "--db");
    if (exists && ::access(file.c_str(), W_OK) != 0) {
        throw base::bad_input("cannot write the store {}: {}", file.string(), std::strerror(errno));
    }
}

/// RFC 3986 percent-encoding of a path, for SQLite's file: URIs and because SOCI splits its
/// connection string at blanks and quotes.
std::string percent_encoded(std::string_view path) {
    std::string encoded;
    for (const char byte : path) {
        const auto code = static_cast<unsigned char>(byte);
        if (std::isalnum(code) != 0 || std::strchr("/-._~", byte) != nullptr) {
            encoded += byte;
        } else {
            encoded += fmt::format("%{:02X}", code);
        }
    }
    return encoded;
}

/// How to open a store that is only read. Where its place may be written, a write connection under
/// query_only is the one that leaves no empty log behind. On a read-only medium nobody else can be
/// writing, so without a log the file cannot change under us (https://www.sqlite.org/wal.html, 5).
std::string read_only_mode(const fs::path& file) {
    std::error_code ignored;
    const bool writable =
        ::access(file.c_str(), W_OK) == 0 && ::access(file.parent_path().c_str(), W_OK) == 0;
    if (writable) return "?mode=rw";
    return fs::exists(file.string() + "-wal", ignored) ? "?mode=ro" : "?mode=ro&immutable=1";
}

std::string without_password(const std::string& url) {
    const auto at = url.rfind('@');
    const auto colon = url.find(':', kPostgresqlScheme.size());
    if (at == std::string::npos || colon == std::string::npos || colon > at) return url;
    return url.substr(0, colon) + ":***" + url.substr(at);
}

}  // namespace

Database::Database(const std::string& url, bool read_only) {
    if (url.starts_with(kSqliteScheme) && url.size() > kSqliteScheme.size()) {
        open_sqlite(url.substr(kSqliteScheme.size()), read_only);
    } else if (url.starts_with(kPostgresqlScheme)) {
        open_postgresql(url, read_only);
    } else {
        throw base::bad_input("the store '{}' is no URL of a store, allowed are {}FILE and {}...",
                              url, kSqliteScheme, kPostgresqlScheme);
    }
}

void Database::open_sqlite(const std::string& file, bool read_only) {
    system_ = System::kSqlite;
    name_ = file;
    if (file.find('\0') != std::string::npos) {
        throw base::bad_input("the store's path {} holds a NUL character", file);
    }
    const fs::path path = fs::absolute(file).lexically_normal();
    std::error_code ignored;
    const bool exists = fs::exists(path, ignored);
    if (fs::is_directory(path, ignored)) {
        throw base::bad_input("cannot open the store {}: it is a directory", file);
    }
    if (exists && !fs::is_regular_file(path, ignored)) {
        throw base::bad_input("cannot open the store {}: it is no regular file", file);
    }
    if (!exists && read_only) {
        throw base::bad_input("cannot open the store {}: there is no such file", file);
    }
    if (exists) require_sqlite_header(path);
    if (!read_only) require_writable_file(path, exists);

    const std::string uri =
        "file:" + percent_encoded(path.string()) + (read_only ? read_only_mode(path) : "");
    use_connections_without_locks();
    guarded("open", [&] {
        session_.open(soci::sqlite3, fmt::format("db={} timeout={}", uri, kBusyTimeoutS));
        execute("PRAGMA foreign_keys = ON");
        execute("PRAGMA synchronous = FULL");
        if (read_only) {
            execute("PRAGMA query_only = ON");
            return;
        }
        auto* backend = static_cast<soci::sqlite3_session_backend*>(session_.get_backend());
        if (sqlite_api::sqlite3_db_readonly(backend->conn_, "main") != 0) {
            throw base::bad_input("cannot write the store {}: it is read-only", name_);
        }
    });
}

void Database::open_postgresql(const std::string& url, bool read_only) {
    system_ = System::kPostgresql;
    name_ = without_password(url);
    try {
        session_.open(*soci::factory_postgresql(), url);
    } catch (const soci::soci_error& error) {
        throw base::bad_input("cannot open the store {}: {}", name_, error.what());
    }
    guarded("open", [&] {
        // Notices ("relation exists, skipping") are no errors; doubles keep all 17 digits.
        execute("SET client_min_messages = warning");
        execute("SET extra_float_digits = 3");
        if (read_only) execute("SET SESSION CHARACTERISTICS AS TRANSACTION READ ONLY");
    });
}

void Database::use_write_ahead_log() {
    if (system_ != System::kSqlite) return;
    std::string mode;
    // The change of mode does not wait for others by the busy timeout as statements do.
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(kBusyTimeoutS);
    while (mode.empty()) {
        try {
            session_ << "PRAGMA journal_mode = WAL", soci::into(mode);
        } catch (const soci::sqlite3_soci_error& error) {
            const bool busy = (error.result() & kPrimaryCode) == SQLITE_BUSY;
            if (!busy || std::chrono::steady_clock::now() > give_up) throw;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    if (mode != "wal") {
        throw base::bad_input(
            "cannot write the store {}: the file system gives no write-ahead log (journal mode {})",
            name_, mode);
    }
}

base::Error Database::translated(std::string_view doing, const soci::soci_error& error) const {
    const std::string reason = error.what();
    const auto* sqlite = dynamic_cast<const soci::sqlite3_soci_error*>(&error);
    if (sqlite == nullptr) {
        return base::failure("cannot {} the store {}: {}", doing, name_, reason);
    }
    switch (sqlite->result() & kPrimaryCode) {
        case SQLITE_NOTADB:
            return base::bad_input("cannot {} the store {}: the file is no SQLite database", doing,
                                   name_);
        case SQLITE_READONLY:
        case SQLITE_PERM:
        case SQLITE_CANTOPEN:
            return base::bad_input("cannot {} the store {}: it cannot be written there ({})", doing,
                                   name_, reason);
        case SQLITE_FULL:
            return base::failure("cannot {} the store {}: the disk is full; nothing was changed",
                                 doing, name_);
        case SQLITE_IOERR:
            return base::failure(
                "cannot {} the store {}: the disk is full or failing ({}); nothing was changed",
                doing, name_, reason);
        case SQLITE_CORRUPT:
            return base::failure("cannot {} the store {}: the database is damaged ({})", doing,
                                 name_, reason);
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return base::failure(
                "cannot {} the store {}: another program has kept it locked for {} s", doing, name_,
                kBusyTimeoutS);
        default:
            return base::failure("cannot {} the store {}: {}", doing, name_, reason);
    }
}

Transaction::Transaction(Database& database) : database_(database) {
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

ReadTransaction::ReadTransaction(Database& database)
    : database_(database), outermost_(!database.reading_) {
    if (!outermost_) return;
    database_.execute(database_.system() == Database::System::kSqlite
                          ? "BEGIN DEFERRED"
                          : "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY");
    database_.reading_ = true;
}

ReadTransaction::~ReadTransaction() {
    if (!outermost_) return;
    database_.reading_ = false;
    try {
        database_.execute("COMMIT");
    } catch (const soci::soci_error&) {
        // Nothing was written; the connection that cannot end it is gone.
    }
}

}  // namespace obscura::analysis
