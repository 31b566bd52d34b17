// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <future>
#include <utility>
#include <vector>

namespace obscura::analysis {

/// Calls `take` with each record that `next` gives, in order, until it gives none (false). While
/// some are taken the next ones are read on another thread; `next` is never called by two at once.
/// What either throws comes through.
template <typename Record, typename Next, typename Take>
void read_ahead(const Next& next, const Take& take) {
    constexpr std::size_t kAtOnce = 4096;
    const auto fill = [&next](std::vector<Record>& records) {
        std::size_t count = 0;
        while (count < records.size() && next(records[count])) ++count;
        return count;
    };
    std::vector<Record> now(kAtOnce);
    std::vector<Record> ahead;
    for (std::size_t count = fill(now); count > 0;) {
        std::future<std::size_t> following;
        if (count == kAtOnce) {
            ahead.resize(kAtOnce);
            following = std::async(std::launch::async, [&] { return fill(ahead); });
        }
        for (std::size_t i = 0; i < count; ++i) take(std::as_const(now[i]));
        count = following.valid() ? following.get() : 0;
        now.swap(ahead);
    }
}

}  // namespace obscura::analysis
