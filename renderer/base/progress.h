// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/time_left.h"

namespace obscura::base {

/// Progress of long work with the time left, on stderr: one line that is drawn over on a terminal,
/// plain lines elsewhere (at most one a second, and the last), nothing when quiet.
class Progress {
  public:
    Progress(std::string title, std::size_t total, bool quiet)
        : Progress(std::move(title), std::vector{total}, quiet) {}
    /// Of work whose steps are of several kinds, so many of each.
    Progress(std::string title, std::vector<std::size_t> totals, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more is done, of that kind; `what` names it.
    void step(std::string_view what, std::size_t kind = 0);
    /// What is known of the time left beside the steps.
    [[nodiscard]] TimeLeft& left() { return left_; }

  private:
    using Clock = std::chrono::steady_clock;

    std::string title_;
    TimeLeft left_;
    double said_s_ = -1.0;  ///< when the last plain line was written
    bool quiet_;
    bool terminal_;
    Clock::time_point start_ = Clock::now();
    double last_s_ = 0.0;  ///< when the last step was done
};

}  // namespace obscura::base
