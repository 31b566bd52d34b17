// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/clopper_pearson.h"

#include <boost/math/distributions/beta.hpp>

#include "renderer/base/check.h"

namespace obscura::analysis {

Possible<Interval> clopper_pearson(std::int64_t successes, std::int64_t n, double confidence) {
    base::check_range("clopper_pearson", "n", n, std::int64_t{0}, 2 * kMaxCount);
    base::check_range("clopper_pearson", "successes", successes, std::int64_t{0}, n);
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input(
            "clopper_pearson: confidence is {}, allowed is more than 0 and less than 1",
            confidence);
    }
    if (n == 0) return Possible<Interval>::none("no votes");
    const double tail = (1.0 - confidence) / 2.0;
    const auto met = static_cast<double>(successes);
    const auto others = static_cast<double>(n - successes);
    using boost::math::beta_distribution;
    Interval interval;
    if (successes > 0) {
        interval.low = boost::math::quantile(beta_distribution<>(met, others + 1.0), tail);
    }
    if (successes < n) {
        interval.high = boost::math::quantile(
            boost::math::complement(beta_distribution<>(met + 1.0, others), tail));
    }
    return interval;
}

}  // namespace obscura::analysis
