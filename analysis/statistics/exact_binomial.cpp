// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/exact_binomial.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <numbers>

#include "analysis/statistics/binomial.h"
#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

/// First k in low .. high for which `holds`, which changes once from false to true; high + 1 when
/// it never does.
template <typename Predicate>
std::int64_t first_that(std::int64_t low, std::int64_t high, Predicate holds) {
    while (low <= high) {
        const std::int64_t middle = low + (high - low) / 2;
        if (holds(middle)) {
            high = middle - 1;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

PValue sum_of(std::pair<double, double> one, std::pair<double, double> other) {
    const double p = std::min(1.0, one.first + other.first);
    if (p > kSmallestProbability) return {p, std::log10(p)};
    const double larger = std::max(one.second, other.second);
    const double smaller = std::min(one.second, other.second);
    return {p, (larger + std::log1p(std::exp(smaller - larger))) / std::numbers::ln10};
}

}  // namespace

Possible<PValue> exact_binomial(std::int64_t successes, std::int64_t n, double share) {
    base::check_range("exact_binomial", "n", n, std::int64_t{0}, 2 * kMaxCount);
    base::check_range("exact_binomial", "successes", successes, std::int64_t{0}, n);
    if (!(share > 0.0 && share < 1.0)) {
        throw base::bad_input("exact_binomial: share is {}, allowed is more than 0 and less than 1",
                              share);
    }
    if (n == 0) return Possible<PValue>::none("no votes");
    const Binomial binomial(n, share);
    const double mean = static_cast<double>(n) * share;
    const auto met = static_cast<double>(successes);
    if (met == mean) return PValue{1.0, 0.0};

    if (share == 0.5) {  // symmetric: the far tail mirrors the near one exactly
        const std::int64_t fewer = std::min(successes, n - successes);
        return sum_of(binomial.lower(fewer), binomial.upper(n - fewer));
    }
    const double tie = binomial.log_pmf(successes) + std::log1p(1e-7);
    if (met < mean) {
        const std::int64_t far =
            first_that(static_cast<std::int64_t>(std::ceil(mean)), n,
                       [&](std::int64_t k) { return binomial.log_pmf(k) <= tie; });
        return sum_of(binomial.lower(successes), binomial.upper(far));
    }
    const std::int64_t far = first_that(0, static_cast<std::int64_t>(std::floor(mean)),
                                        [&](std::int64_t k) { return binomial.log_pmf(k) > tie; }) -
                             1;
    return sum_of(binomial.lower(far), binomial.upper(successes));
}

Possible<PValue> exact_binomial_of_share(double share, std::int64_t n) {
    base::check_range("exact_binomial_of_share", "n", n, std::int64_t{0}, 2 * kMaxCount);
    base::check_range("exact_binomial_of_share", "share", share, 0.0, 1.0);
    const auto count = static_cast<double>(n);
    const double met = std::max(share, 1.0 - share) * count;
    if (met == std::round(met)) return exact_binomial(static_cast<std::int64_t>(met), n);
    // P(Binomial(n, 1/2) >= k) = I_1/2(k, n - k + 1) (NIST DLMF 8.17.5), for any k.
    const double tail = boost::math::ibeta(met, count - met + 1.0, 0.5);
    const double p = std::min(1.0, 2.0 * tail);
    if (p > kSmallestProbability) return PValue{p, std::log10(p)};
    return exact_binomial(static_cast<std::int64_t>(std::floor(met)), n);
}

}  // namespace obscura::analysis
