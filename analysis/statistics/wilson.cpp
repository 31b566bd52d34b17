// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/wilson.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "renderer/base/check.h"

namespace obscura::analysis {

Possible<Interval> wilson(std::int64_t successes, std::int64_t n, double confidence) {
    base::check_range("wilson", "n", n, std::int64_t{0}, 2 * kMaxCount);
    base::check_range("wilson", "successes", successes, std::int64_t{0}, n);
    const double share = n == 0 ? 0.0 : static_cast<double>(successes) / static_cast<double>(n);
    return wilson_of_share(share, n, confidence);
}

Possible<Interval> wilson_of_share(double share, std::int64_t n, double confidence) {
    base::check_range("wilson_of_share", "n", n, std::int64_t{0}, 2 * kMaxCount);
    base::check_range("wilson_of_share", "share", share, 0.0, 1.0);
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input("wilson: confidence is {}, allowed is more than 0 and less than 1",
                              confidence);
    }
    if (n == 0) return Possible<Interval>::none("no votes");
    const double z = boost::math::quantile(
        boost::math::complement(boost::math::normal(), (1.0 - confidence) / 2.0));
    const auto count = static_cast<double>(n);
    const double z2 = z * z / count;
    const double centre = (share + z2 / 2.0) / (1.0 + z2);
    const double half =
        z * std::sqrt(share * (1.0 - share) / count + z2 / (4.0 * count)) / (1.0 + z2);
    Interval interval{centre - half, centre + half};
    // At the ends the formula gives exactly 0 and 1; rounding would miss them.
    interval.low = share == 0.0 ? 0.0 : std::clamp(interval.low, 0.0, share);
    interval.high = share == 1.0 ? 1.0 : std::clamp(interval.high, share, 1.0);
    return interval;
}

}  // namespace obscura::analysis
