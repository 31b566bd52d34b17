// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/clopper_pearson.h"

#include <boost/math/distributions/beta.hpp>

#include <string_view>

#include "renderer/base/check.h"

namespace obscura::analysis {

namespace {

void check(std::string_view function, std::int64_t n, double confidence) {
    base::check_range(function, "n", n, std::int64_t{0}, 2 * kMaxCount);
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input("{}: confidence is {}, allowed is more than 0 and less than 1",
                              function, confidence);
    }
}

/// Of `met` successes and `others`, which need not be whole.
Interval exact(double met, double others, double confidence) {
    using boost::math::beta_distribution;
    const double tail = (1.0 - confidence) / 2.0;
    Interval interval{0.0, 1.0};
    if (met > 0.0) {
        interval.low = boost::math::quantile(beta_distribution<>(met, others + 1.0), tail);
    }
    if (others > 0.0) {
        interval.high = boost::math::quantile(
            boost::math::complement(beta_distribution<>(met + 1.0, others), tail));
    }
    return interval;
}

}  // namespace

Possible<Interval> clopper_pearson(std::int64_t successes, std::int64_t n, double confidence) {
    check("clopper_pearson", n, confidence);
    base::check_range("clopper_pearson", "successes", successes, std::int64_t{0}, n);
    if (n == 0) return Possible<Interval>::none("no votes");
    return exact(static_cast<double>(successes), static_cast<double>(n - successes), confidence);
}

Possible<Interval> clopper_pearson_of_share(double share, std::int64_t n, double confidence) {
    check("clopper_pearson_of_share", n, confidence);
    base::check_range("clopper_pearson_of_share", "share", share, 0.0, 1.0);
    if (n == 0) return Possible<Interval>::none("no votes");
    const auto count = static_cast<double>(n);
    return exact(share * count, (1.0 - share) * count, confidence);
}

}  // namespace obscura::analysis
