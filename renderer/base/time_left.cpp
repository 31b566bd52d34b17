// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/time_left.h"

#include <algorithm>

namespace obscura::base {

TimeLeft::TimeLeft(std::vector<std::size_t> counts) {
    for (const std::size_t count : counts) kinds_.push_back({count});
}

void TimeLeft::done(std::size_t kind, double seconds) {
    Kind& of = kinds_.at(kind);
    ++of.done;
    of.count = std::max(of.count, of.done);
    of.spent_s += seconds;
}

void TimeLeft::leave_out(std::size_t kind, std::size_t steps) {
    Kind& of = kinds_.at(kind);
    of.count -= std::min(steps, of.count - of.done);
}

std::size_t TimeLeft::steps() const {
    std::size_t sum = 0;
    for (const Kind& kind : kinds_) sum += kind.count;
    return sum;
}

std::size_t TimeLeft::steps_done() const {
    std::size_t sum = 0;
    for (const Kind& kind : kinds_) sum += kind.done;
    return sum;
}

double TimeLeft::seconds() const {
    double sum_s = 0.0;
    for (const Kind& kind : kinds_) {
        const double each_s =
            kind.done > 0 ? kind.spent_s / static_cast<double>(kind.done) : kind.expected_s;
        sum_s += each_s * static_cast<double>(kind.count - kind.done);
    }
    return sum_s;
}

}  // namespace obscura::base
