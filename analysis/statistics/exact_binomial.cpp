// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/exact_binomial.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

/// Probabilities below this have lost digits or vanished.
constexpr double kSmallest = std::numeric_limits<double>::min() / 1e-16;

/// A binomial distribution whose tails keep their size where doubles end.
class Binomial {
  public:
    Binomial(std::int64_t n, double share)
        : n_(n), share_(share), distribution_(static_cast<double>(n), share) {}

    /// Natural logarithm of P(X = k).
    [[nodiscard]] double log_pmf(std::int64_t k) const {
        const double pmf = boost::math::pdf(distribution_, static_cast<double>(k));
        if (pmf > kSmallest) return std::log(pmf);
        const double n = static_cast<double>(n_);
        const double x = static_cast<double>(k);
        using boost::math::lgamma;
        return lgamma(n + 1.0) - lgamma(x + 1.0) - lgamma(n - x + 1.0) + x * std::log(share_) +
               (n - x) * std::log1p(-share_);
    }

    /// P(X <= k) and its natural logarithm; nothing below 0.
    [[nodiscard]] std::pair<double, double> lower(std::int64_t k) const {
        if (k < 0) return {0.0, -std::numeric_limits<double>::infinity()};
        const double p = boost::math::cdf(distribution_, static_cast<double>(std::min(k, n_)));
        if (p > kSmallest) return {p, std::log(p)};
        // P(X = k - 1) / P(X = k) = k (1 - share) / ((n - k + 1) share): far out a falling series.
        return {p, log_pmf(k) + log_of_series(static_cast<double>(k), static_cast<double>(n_ - k),
                                              (1.0 - share_) / share_)};
    }

    /// P(X >= k) and its natural logarithm; nothing above n.
    [[nodiscard]] std::pair<double, double> upper(std::int64_t k) const {
        if (k > n_) return {0.0, -std::numeric_limits<double>::infinity()};
        if (k <= 0) return {1.0, 0.0};
        const double p =
            boost::math::cdf(boost::math::complement(distribution_, static_cast<double>(k - 1)));
        if (p > kSmallest) return {p, std::log(p)};
        return {p, log_pmf(k) + log_of_series(static_cast<double>(n_ - k), static_cast<double>(k),
                                              share_ / (1.0 - share_))};
    }

  private:
    /// log(1 + r_1 + r_1 r_2 + ...), r_i = (left - i + 1) / (right + i) odds.
    static double log_of_series(double left, double right, double odds) {
        double sum = 1.0;
        double term = 1.0;
        for (double i = 1.0; i <= left && term > sum * 1e-17; ++i) {
            term *= (left - i + 1.0) / (right + i) * odds;
            sum += term;
        }
        return std::log(sum);
    }

    std::int64_t n_;
    double share_;
    boost::math::binomial distribution_;
};

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
    if (p > kSmallest) return {p, std::log10(p)};
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

}  // namespace obscura::analysis
