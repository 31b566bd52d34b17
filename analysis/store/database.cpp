// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/database.h"

#include <fcntl.h>
#include <soci/postgresql/soci-postgresql.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "analysis/store/address.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

/// How long a statement waits for another process that is writing.
constexpr int kBusyTimeoutS = 10;
/// The low byte of an extended result code (https://www.sqlite.org/rescode.html).
constexpr int kPrimaryCode = 0xff;

/// A store from this size on, 150,000 answers, is not checked index by index: that takes three
/// times as long as to read every page.
constexpr std::uintmax_t kLargeBytes = std::uintmax_t{64} << 20U;

/// First 16 bytes of a database (https://www.sqlite.org/fileformat.html, 1.3.1).
constexpr std::string_view kSqliteMagic{"SQLite format 3\0", 16};

/// No connection is used by two threads at once, so SQLite need not lock one for each value that is
/// read, a fifth of the time of an export (https://www.sqlite.org/threadsafe.html, multi-thread).
void use_connections_without_locks() {
    static const int done = sqlite_api::sqlite3_config(SQLITE_CONFIG_MULTITHREAD);
    (void)done;  // once SQLite is in use it stays as it is, slower and right
}

/// A message of a server, which may have several lines.
std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
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

/// What people answered is read by nobody else on the machine.
void make_private(const fs::path& file) {
    constexpr mode_t kOwnerOnly = 0600;
    const int descriptor =
        ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kOwnerOnly);
    if (descriptor >= 0) ::close(descriptor);  // else SQLite says what is wrong
}

void require_writable_file(const fs::path& file, bool exists) {
    base::require_writable_folder(file.parent_path(), "--db");
    fs::create_directories(file.parent_path());
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
/// query_only can fold in what a program that was killed left beside it. On a read-only medium
/// nobody else can be writing, so without a log or journal the file cannot change under us
/// (https://www.sqlite.org/wal.html, 5).
std::string read_only_mode(const fs::path& file) {
    std::error_code ignored;
    const bool writable =
        ::access(file.c_str(), W_OK) == 0 && ::access(file.parent_path().c_str(), W_OK) == 0;
    if (writable) return "?mode=rw";
    const bool alone = !fs::exists(file.string() + "-wal", ignored) &&
                       !fs::exists(file.string() + "-journal", ignored);
    return alone ? "?mode=ro&immutable=1" : "?mode=ro";
}

std::string connection_string(const std::string& uri) {
    return fmt::format("db={} timeout={}", uri, kBusyTimeoutS);
}

/// "ok", or the first damage that `check`, a pragma of SQLite's, meets.
std::string finding_of(soci::session& session, std::string_view check) {
    std::string finding;
    session << fmt::format("PRAGMA {}(1)", check), soci::into(finding);
    return finding;
}

sqlite_api::sqlite3* connection_of(soci::session& session) {
    return static_cast<soci::sqlite3_session_backend*>(session.get_backend())->conn_;
}

}  // namespace

Database::Database(const std::string& url, bool read_only) {
    const StoreAddress address = store_address(url);
    name_ = address.shown;
    if (address.file.empty()) {
        open_postgresql(address.connection, read_only);
    } else {
        open_sqlite(address.file, read_only);
    }
}

void Database::open_sqlite(const std::string& file, bool read_only) {
    system_ = System::kSqlite;
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

    if (!exists && !read_only) make_private(path);

    uri_ = "file:" + percent_encoded(path.string()) + (read_only ? read_only_mode(path) : "");
    use_connections_without_locks();
    guarded("open", [&] {
        session_.open(soci::sqlite3, connection_string(uri_));
        execute("PRAGMA foreign_keys = ON");
        // FULL would leave the deletion of the journal, which is the commit, to the system's
        // leisure.
        execute("PRAGMA synchronous = EXTRA");
        if (read_only) {
            execute("PRAGMA query_only = ON");
            return;
        }
        if (sqlite_api::sqlite3_db_readonly(sqlite(), "main") != 0) {
            throw base::bad_input("cannot write the store {}: it is read-only", name_);
        }
    });
}

void Database::open_postgresql(const std::string& connection, bool read_only) {
    system_ = System::kPostgresql;
    read_only_ = read_only;
    try {
        session_.open(soci::postgresql, connection);
    } catch (const soci::soci_error& error) {
        throw base::bad_input("cannot open the store {}: {}", name_, one_line(error.what()));
    }
    connected_ = true;
    guarded("open", [&] { settle_connection(); });
}

void Database::settle_connection() {
    // Notices ("relation exists, skipping") are no errors; doubles keep all 17 digits.
    execute("SET client_min_messages = warning");
    execute("SET extra_float_digits = 3");
    // An answer is on the disk of the server when it is acknowledged.
    execute("SET synchronous_commit = on");
    // What two kiosks do at once is as if one came after the other; where it cannot be, one of them
    // is told to try again.
    execute("SET SESSION CHARACTERISTICS AS TRANSACTION ISOLATION LEVEL SERIALIZABLE");
    if (read_only_) execute("SET SESSION CHARACTERISTICS AS TRANSACTION READ ONLY");
}

void Database::take_up_connection() {
    if (!connected_ || reading_ != nullptr) return;
    const auto* backend = static_cast<soci::postgresql_session_backend*>(session_.get_backend());
    if (backend != nullptr && PQstatus(backend->conn_) == CONNECTION_OK) return;
    session_.reconnect();
    settle_connection();
}

bool Database::asks_to_try_again(const soci::soci_error& error) {
    const auto* of_server = dynamic_cast<const soci::postgresql_soci_error*>(&error);
    if (of_server == nullptr) return false;
    // serialization_failure, deadlock_detected, and unique_violation: what another has just taken
    // is refused in words at the next try (PostgreSQL 15, 13.5)
    const std::string state = of_server->sqlstate();
    return state == "40001" || state == "40P01" || state == "23505";
}

void Database::keep_in_one_file() {
    if (system_ != System::kSqlite) return;
    std::string mode;
    // The change of mode does not wait for others by the busy timeout as statements do.
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(kBusyTimeoutS);
    while (mode.empty()) {
        try {
            session_ << "PRAGMA journal_mode = DELETE", soci::into(mode);
        } catch (const soci::sqlite3_soci_error& error) {
            const bool busy = (error.result() & kPrimaryCode) == SQLITE_BUSY;
            if (!busy || std::chrono::steady_clock::now() > give_up) throw;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    if (mode != "delete") {
        throw base::failure("cannot write the store {}: its journal mode stays {}", name_, mode);
    }
}

void Database::do_not_wait_for_the_disk() {
    if (system_ == System::kSqlite) execute("PRAGMA synchronous = OFF");
}

bool Database::is_large() const {
    std::error_code ignored;
    return fs::file_size(name_, ignored) >= kLargeBytes;
}

void Database::require_whole() {
    if (system_ != System::kSqlite) return;
    require_ok(finding_of(session_, is_large() ? "quick_check" : "integrity_check"));
}

void Database::require_whole_beside() {
    if (system_ != System::kSqlite || !is_large()) return require_whole();
    check_ = std::async(std::launch::async, [uri = uri_] {
        soci::session beside(soci::sqlite3, connection_string(uri));
        // What a value may be is held by its reader (columns.cpp), in half the time.
        beside << "PRAGMA ignore_check_constraints = ON";
        return finding_of(beside, "quick_check");
    });
}

void Database::await_check() {
    if (check_.valid()) require_ok(check_.get());
}

void Database::require_ok(const std::string& finding) const {
    if (finding != "ok") throw damaged("open", one_line(finding));
}

void Database::require_in_place() {
    if (system_ != System::kSqlite) return;
    int moved = 0;
    sqlite_api::sqlite3_file_control(sqlite(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
    if (moved == 0) return;
    std::error_code ignored;
    throw base::failure(
        "the store {} {} since it was opened: put it back. Until this program ends, a deleted one "
        "can be copied from /proc/{}/fd",
        name_, fs::exists(name_, ignored) ? "was replaced by another file" : "was moved or deleted",
        ::getpid());
}

sqlite_api::sqlite3* Database::sqlite() { return connection_of(session_); }

void Database::copy_sqlite_to(soci::session& copy) {
    sqlite_api::sqlite3* to = connection_of(copy);
    sqlite_api::sqlite3_backup* backup =
        sqlite_api::sqlite3_backup_init(to, "main", sqlite(), "main");
    constexpr int kAllPages = -1;
    if (backup != nullptr) (void)sqlite_api::sqlite3_backup_step(backup, kAllPages);
    if (backup == nullptr || sqlite_api::sqlite3_backup_finish(backup) != SQLITE_OK) {
        throw soci::sqlite3_soci_error(sqlite_api::sqlite3_errmsg(to),
                                       sqlite_api::sqlite3_errcode(to));
    }
}

void Database::copy_to(const std::string& file) {
    assert(system_ == System::kSqlite);
    soci::session copy(soci::sqlite3,
                       fmt::format("db=file:{} synchronous=full", percent_encoded(file)));
    copy_sqlite_to(copy);
}

base::Error Database::damaged(std::string_view doing, std::string_view reason) const {
    return base::bad_input(
        "cannot {} the store {}: the database is damaged ({}). Keep this file, go on with a whole "
        "copy, and see what can be saved: sqlite3 {} .recover | sqlite3 recovered.sqlite",
        doing, name_, reason, name_);
}

base::Error Database::translated(std::string_view doing, const soci::soci_error& error) const {
    const std::string reason = error.what();
    const auto* sqlite = dynamic_cast<const soci::sqlite3_soci_error*>(&error);
    if (sqlite == nullptr) return translated_of_server(doing, error);
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
            return damaged(doing, reason);
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return base::failure(
                "cannot {} the store {}: another program has kept it locked for {} s", doing, name_,
                kBusyTimeoutS);
        default:
            return base::failure("cannot {} the store {}: {}", doing, name_, reason);
    }
}

base::Error Database::translated_of_server(std::string_view doing,
                                           const soci::soci_error& error) const {
    const std::string reason = one_line(error.what());
    const auto* of_server = dynamic_cast<const soci::postgresql_soci_error*>(&error);
    const std::string state = of_server != nullptr ? of_server->sqlstate() : "";
    // read_only_sql_transaction and insufficient_privilege (PostgreSQL 15, appendix A)
    if (state == "25006" || state == "42501") {
        return base::bad_input("cannot {} the store {}: it cannot be written there ({})", doing,
                               name_, reason);
    }
    return base::failure("cannot {} the store {}: {}", doing, name_, reason);
}

}  // namespace obscura::analysis
