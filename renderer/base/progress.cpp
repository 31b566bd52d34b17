// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace obscura::base {

Progress::Progress(std::string title, std::size_t total, bool quiet)
    : title_(std::move(title)),
      total_(total),
      quiet_(quiet),
      terminal_(::isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
    if (terminal_ && !quiet_ && done_ > 0) fmt::print(stderr, "\n");
}

void Progress::step(std::string_view what) {
    ++done_;
    if (quiet_) return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    const bool last = done_ == total_;
    if (!terminal_ && !last && spent.count() - said_s_ < 1.0) return;
    said_s_ = spent.count();
    const double left_s =
        spent.count() / static_cast<double>(done_) * static_cast<double>(total_ - done_);
    const std::string line = fmt::format("{} {}/{} {} ({:.1f} s, {:.0f} s left)", title_, done_,
                                         total_, what, spent.count(), left_s);
    if (terminal_) {
        fmt::print(stderr, "\r\033[K{}", line);
        std::fflush(stderr);
    } else {
        fmt::print(stderr, "{}\n", line);
    }
}

}  // namespace obscura::base
