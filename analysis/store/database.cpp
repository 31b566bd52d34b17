// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/database.h"

#include <soci/sqlite3/soci-sqlite3.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

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

/// First 16 bytes of a database (https://www.sqlite.org/fileformat.html, 1.3.1).
constexpr std::string_view kSqliteMagic{"SQLite format 3\0", 16};

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

    std::string uri = "file:" + percent_encoded(path.string());
    if (read_only) {
        uri += "?mode=ro";
        // SQLite reads a write-ahead log only where it may make its -shm file; on a read-only
        // medium nobody can be writing, so the file cannot change under us.
        const bool sealed = ::access(path.parent_path().c_str(), W_OK) != 0;
        if (sealed && !fs::exists(path.string() + "-wal", ignored)) uri += "&immutable=1";
    }
    guarded("open", [&] {
        session_.open(soci::sqlite3, fmt::format("db={} timeout={}", uri, kBusyTimeoutS));
        execute("PRAGMA foreign_keys = ON");
        execute("PRAGMA synchronous = FULL");
        if (read_only) return;
        auto* backend = static_cast<soci::sqlite3_session_backend*>(session_.get_backend());
        if (sqlite_api::sqlite3_db_readonly(backend->conn_, "main") != 0) {
            throw base::bad_input("cannot write the store {}: it is read-only", name_);
        }
    });
}

void Database::open_postgresql(const std::string& url, bool read_only) {
    system_ = System::kPostgresql;
    name_ = without_password(url);
    guarded("open", [&] {
        session_.open(*soci::factory_postgresql(), url);
        // Notices ("relation exists, skipping") are no errors; doubles keep all 17 digits.
        execute("SET client_min_messages = warning");
        execute("SET extra_float_digits = 3");
        if (read_only) execute("SET SESSION CHARACTERISTICS AS TRANSACTION READ ONLY");
    });
}

void Database::use_write_ahead_log() {
    if (system_ != System::kSqlite) return;
    std::string mode;
    session_ << "PRAGMA journal_mode", soci::into(mode);
    if (mode == "wal") return;
    session_ << "PRAGMA journal_mode = WAL", soci::into(mode);
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
        if (error.get_error_category() == soci::soci_error::connection_error) {
            return base::bad_input("cannot {} the store {}: {}", doing, name_, reason);
        }
        return base::failure("cannot {} the store {}: {}", doing, name_, reason);
    }
    switch (sqlite->result() & 0xff) {  // the low byte is the primary code
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

}  // namespace obscura::analysis
