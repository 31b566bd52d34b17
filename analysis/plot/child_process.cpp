// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/plot/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

extern char** environ;

namespace obscura::analysis {
namespace {

using Clock = std::chrono::steady_clock;

/// A pipe whose ends no other child gets.
class Pipe {
  public:
    Pipe() { ok_ = ::pipe2(ends_.data(), O_CLOEXEC) == 0; }
    ~Pipe() {
        close_writing();
        if (ends_[0] >= 0) ::close(ends_[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] int reading() const { return ends_[0]; }
    [[nodiscard]] int writing() const { return ends_[1]; }
    void close_writing() {
        if (ends_[1] >= 0) ::close(ends_[1]);
        ends_[1] = -1;
    }

  private:
    std::array<int, 2> ends_{-1, -1};
    bool ok_ = false;
};

/// What a child does with its files before it begins.
class FileActions {
  public:
    FileActions() { posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;
    [[nodiscard]] posix_spawn_file_actions_t* get() { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

/// 0, or why the child could not begin.
int spawn(const std::vector<std::string>& words, const std::filesystem::path& folder,
          const Pipe& out, const Pipe& err, pid_t& child) {
    FileActions actions;
    posix_spawn_file_actions_addchdir_np(actions.get(), folder.c_str());
    posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(actions.get(), out.writing(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(actions.get(), err.writing(), STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    return ::posix_spawnp(&child, words.front().c_str(), actions.get(), nullptr, arguments.data(),
                          environ);
}

/// Reads both pipes until they are closed; false when the time is over first.
bool read_both(std::array<pollfd, 2> pipes, std::array<std::string*, 2> texts,
               Clock::time_point deadline) {
    int open = 2;
    while (open > 0) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return false;
        if (::poll(pipes.data(), pipes.size(), static_cast<int>(left)) < 0 && errno != EINTR) {
            return false;
        }
        for (std::size_t i = 0; i < pipes.size(); ++i) {
            if (pipes[i].fd < 0 || pipes[i].revents == 0) continue;
            std::array<char, 65536> buffer;
            const ssize_t length = ::read(pipes[i].fd, buffer.data(), buffer.size());
            if (length > 0) {
                texts[i]->append(buffer.data(), static_cast<std::size_t>(length));
            } else if (length == 0 || errno != EINTR) {
                pipes[i].fd = -1;
                --open;
            }
        }
    }
    return true;
}

/// The last part of what a program complained about, on one line.
std::string end_of(const std::string& text) {
    constexpr std::size_t kShown = 400;
    std::string line = text.substr(text.size() - std::min(text.size(), kShown));
    for (char& letter : line) {
        if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
    }
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) return "";
    return line.substr(first, line.find_last_not_of(' ') - first + 1);
}

std::string problem_of(const std::string& name, int status, const std::string& complaint) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
    const std::string how = WIFEXITED(status)
                                ? fmt::format("ended with {}", WEXITSTATUS(status))
                                : fmt::format("was ended by signal {}", WTERMSIG(status));
    const std::string words = end_of(complaint);
    return fmt::format("{} {}{}{}", name, how, words.empty() ? "" : ": ", words);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& words,
                          const std::filesystem::path& folder, std::chrono::milliseconds limit) {
    const std::string& name = words.front();
    Pipe out;
    Pipe err;
    if (!out.ok() || !err.ok()) return {"", fmt::format("no pipe to {} can be made", name)};
    pid_t child = -1;
    if (const int error = spawn(words, folder, out, err, child); error != 0) {
        if (error == ENOENT) return {"", fmt::format("{} is not in the PATH", name)};
        return {"", fmt::format("{} cannot be run: {}", name, std::strerror(error))};
    }
    out.close_writing();
    err.close_writing();
    ProcessResult result;
    std::string complaint;
    const bool ended =
        read_both({pollfd{out.reading(), POLLIN, 0}, pollfd{err.reading(), POLLIN, 0}},
                  {&result.out, &complaint}, Clock::now() + limit);
    if (!ended) ::kill(child, SIGKILL);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!ended) return {"", fmt::format("{} did not end within {} ms", name, limit.count())};
    result.problem = problem_of(name, status, complaint);
    return result;
}

}  // namespace obscura::analysis
