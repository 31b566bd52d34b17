// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace obscura::base {

Progress::Progress(std::string title, std::vector<std::size_t> totals, bool quiet)
    : title_(std::move(title)),
      left_(std::move(totals)),
      quiet_(quiet),
      terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (terminal_ && !quiet_ && left_.steps_done() > 0) fmt::print(stderr, "\n");
}

void Progress::step(std::string_view what, std::size_t kind) {
    const std::chrono::duration<double> spent = Clock::now() - start_;
    left_.done(kind, spent.count() - last_s_);
    last_s_ = spent.count();
    if (quiet_) return;
    const bool last = left_.steps_done() == left_.steps();
    if (!terminal_ && !last && spent.count() - said_s_ < 1.0) return;
    said_s_ = spent.count();
    const std::string line =
        fmt::format("{} {}/{} {} ({:.1f} s, {:.0f} s left)", title_, left_.steps_done(),
                    left_.steps(), what, spent.count(), left_.seconds());
    if (terminal_) {
        fmt::print(stderr, "\r\033[K{}", line);
        std::fflush(stderr);
    } else {
        fmt::print(stderr, "{}\n", line);
    }
}

}  // namespace obscura::base
