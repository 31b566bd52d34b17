// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/share_difference.h"

#include <cmath>

#include "analysis/statistics/check_votes.h"
#include "analysis/statistics/wilson.h"

namespace obscura::analysis {

Possible<Interval> share_difference(const Votes& one, const Votes& other, double confidence) {
    check_votes("share_difference", one);
    check_votes("share_difference", other);
    const auto of_one = wilson(one.b, one.n(), confidence);
    const auto of_other = wilson(other.b, other.n(), confidence);
    if (!of_one.has_value() || !of_other.has_value()) return Possible<Interval>::none("no votes");
    const double share_one = static_cast<double>(one.b) / static_cast<double>(one.n());
    const double share_other = static_cast<double>(other.b) / static_cast<double>(other.n());
    const double difference = share_other - share_one;
    return Interval{difference - std::hypot(share_other - of_other->low, of_one->high - share_one),
                    difference + std::hypot(of_other->high - share_other, share_one - of_one->low)};
}

}  // namespace obscura::analysis
