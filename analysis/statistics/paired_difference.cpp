// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/paired_difference.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/check_votes.h"
#include "analysis/statistics/clopper_pearson.h"
#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

/// How far an end of the interval lies from the difference: `one` and `other` are how far the ends
/// that decide it lie from the two shares, which correlate by -`correlation`.
double reach(double one, double other, double correlation) {
    return std::sqrt(one * one + other * other + 2.0 * correlation * one * other);
}

}  // namespace

Possible<Interval> paired_difference(const Votes& changed, std::int64_t n, double confidence) {
    check_votes("paired_difference", changed);
    base::check_range("paired_difference", "n", n, std::int64_t{0}, kMaxCount);
    base::check_range("paired_difference", "changes", changed.n(), std::int64_t{0}, n);
    const auto down = clopper_pearson(changed.a, n, confidence);
    const auto up = clopper_pearson(changed.b, n, confidence);
    if (!down.has_value()) return Possible<Interval>::none("no participants");
    const double share_down = static_cast<double>(changed.a) / static_cast<double>(n);
    const double share_up = static_cast<double>(changed.b) / static_cast<double>(n);
    // None seen is not none there: half a change is added to each way, or the interval of few who
    // all changed one way would be too short (92 % at 5 participants and shares of .45).
    const double likely_down = (static_cast<double>(changed.a) + 0.5) / static_cast<double>(n + 1);
    const double likely_up = (static_cast<double>(changed.b) + 0.5) / static_cast<double>(n + 1);
    const double correlation = std::min(
        1.0, std::sqrt(likely_down * likely_up / ((1.0 - likely_down) * (1.0 - likely_up))));
    const double difference = share_up - share_down;
    const double low = difference - reach(share_up - up->low, down->high - share_down, correlation);
    const double high =
        difference + reach(up->high - share_up, share_down - down->low, correlation);
    return Interval{std::max(low, -1.0), std::min(high, 1.0)};
}

}  // namespace obscura::analysis
