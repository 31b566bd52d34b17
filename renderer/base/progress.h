// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace obscura::base {

/// Progress of long work with the time left, on stderr: one line that is drawn over on a terminal,
/// plain lines elsewhere (at most one a second, and the last), nothing when quiet.
class Progress {
  public:
    Progress(std::string title, std::size_t total, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more of `total` is done; `what` names it. Time left is the mean time of those done so
    /// far times those that remain.
    void step(std::string_view what);

  private:
    std::string title_;
    std::size_t total_;
    std::size_t done_ = 0;
    double said_s_ = -1.0;  ///< when the last plain line was written
    bool quiet_;
    bool terminal_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace obscura::base
