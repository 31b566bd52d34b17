// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace obscura::base {

/// Calls `act(i)` for i in [0, count) on that many threads, 0: one a core. What the calls write
/// must not overlap. Throws what the first of them that failed threw.
template <typename Act>
void in_parallel(int count, int threads, const Act& act) {
    std::atomic<int> next{0};
    std::exception_ptr error;
    std::mutex error_lock;
    const auto work = [&] {
        try {
            for (int i = next++; i < count; i = next++) act(i);
        } catch (...) {
            const std::scoped_lock lock(error_lock);
            if (!error) error = std::current_exception();
            next = count;
        }
    };
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < std::min(threads > 0 ? threads : cores, count); ++i) {
            others.emplace_back(work);
        }
        work();
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace obscura::base
