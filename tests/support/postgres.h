// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>
#include <filesystem>
#include <string>

namespace obscura::tests {

/// A PostgreSQL 15 server of the tests' own: a cluster in a temporary folder, run by an ordinary
/// user (`postgres` where the tests run as root) on a free port of the loopback, for as long as the
/// program runs. Throws std::runtime_error where it does not start.
class PostgresServer {
  public:
    /// The one of this program, started at the first call.
    static PostgresServer& shared();

    PostgresServer(const PostgresServer&) = delete;
    PostgresServer& operator=(const PostgresServer&) = delete;
    ~PostgresServer();

    /// The URL of a new database, empty.
    [[nodiscard]] std::string new_database();
    /// Runs a statement in a database, as the user who may do everything.
    void execute(const std::string& sql, const std::string& database = "postgres") const;
    [[nodiscard]] int port() const { return port_; }
    /// Stops the server at once, as a crash does.
    void stop();
    void start();
    void restart() {
        stop();
        start();
    }

  private:
    PostgresServer();

    std::filesystem::path folder_;
    int port_ = 0;
    int databases_ = 0;
    pid_t process_ = -1;
};

}  // namespace obscura::tests
