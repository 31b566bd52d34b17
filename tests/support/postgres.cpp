// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "tests/support/postgres.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <libpq-fe.h>
#include <pwd.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace obscura::tests {
namespace {

constexpr const char* kPrograms = "/usr/lib/postgresql/15/bin/";
constexpr int kPatience_s = 120;

struct Finish {
    void operator()(PGconn* connection) const { PQfinish(connection); }
};

int free_port() {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    const bool bound = ::bind(socket, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
                       ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0;
    ::close(socket);
    if (!bound) throw std::runtime_error("no free port");
    return ntohs(address.sin_port);
}

/// PostgreSQL does not run as root.
void become_ordinary() {
    if (::geteuid() != 0) return;
    const passwd* user = ::getpwnam("postgres");
    if (user == nullptr || ::setgid(user->pw_gid) != 0 || ::setuid(user->pw_uid) != 0) ::_exit(126);
}

/// Starts a program of PostgreSQL; its output goes to `log`.
pid_t spawn(const std::vector<std::string>& command, const std::filesystem::path& log) {
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (std::freopen(log.c_str(), "a", stdout) == nullptr) ::_exit(126);
    ::dup2(STDOUT_FILENO, STDERR_FILENO);
    become_ordinary();
    // It ends with the tests, however those end.
    ::prctl(PR_SET_PDEATHSIG, SIGQUIT);
    if (::getppid() != parent) ::_exit(126);
    ::execv(words.front(), words.data());
    ::_exit(127);
}

}  // namespace

PostgresServer& PostgresServer::shared() {
    static PostgresServer server;
    return server;
}

PostgresServer::PostgresServer()
    : folder_(std::filesystem::temp_directory_path() /
              fmt::format("obscura-postgres-{}", ::getpid())),
      port_(free_port()) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    if (::geteuid() == 0) {
        const passwd* user = ::getpwnam("postgres");
        if (user == nullptr || ::chown(folder_.c_str(), user->pw_uid, user->pw_gid) != 0) {
            throw std::runtime_error("no user postgres: install postgresql-15");
        }
    }
    const pid_t made = spawn(
        {std::string(kPrograms) + "initdb", "-D", (folder_ / "data").string(), "-U", "operator",
         "-A", "trust", "-E", "UTF8", "--locale=C.UTF-8", "--no-sync", "--no-instructions"},
        folder_ / "log");
    int status = -1;
    ::waitpid(made, &status, 0);
    if (status != 0) throw std::runtime_error("initdb fails, see " + (folder_ / "log").string());
    std::ofstream(folder_ / "data" / "postgresql.auto.conf", std::ios::app) << "fsync = off\n";
    start();
}

PostgresServer::~PostgresServer() {
    stop();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

void PostgresServer::start() {
    process_ =
        spawn({std::string(kPrograms) + "postgres", "-D", (folder_ / "data").string(), "-p",
               std::to_string(port_), "-h", "127.0.0.1", "-k", "", "-c", "max_connections=60"},
              folder_ / "log");
    const std::string url =
        fmt::format("host=127.0.0.1 port={} user=operator dbname=postgres", port_);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(kPatience_s);
    while (PQping(url.c_str()) != PQPING_OK) {
        if (std::chrono::steady_clock::now() > end) {
            throw std::runtime_error("PostgreSQL does not start, see " +
                                     (folder_ / "log").string());
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

void PostgresServer::stop() {
    ::kill(process_, SIGQUIT);
    ::waitpid(process_, nullptr, 0);
}

void PostgresServer::execute(const std::string& sql, const std::string& database) const {
    const std::string url =
        fmt::format("host=127.0.0.1 port={} user=operator dbname={}", port_, database);
    const std::unique_ptr<PGconn, Finish> connection(PQconnectdb(url.c_str()));
    PGresult* result = PQexec(connection.get(), sql.c_str());
    const ExecStatusType status = PQresultStatus(result);
    PQclear(result);
    if (status != PGRES_COMMAND_OK && status != PGRES_TUPLES_OK) {
        throw std::runtime_error(sql + ": " + PQerrorMessage(connection.get()));
    }
}

std::string PostgresServer::new_database() {
    const std::string name = fmt::format("answers{}", ++databases_);
    execute("CREATE DATABASE " + name + " STRATEGY file_copy");
    return fmt::format("postgresql://operator@127.0.0.1:{}/{}", port_, name);
}

}  // namespace obscura::tests
