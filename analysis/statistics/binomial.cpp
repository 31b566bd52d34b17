// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/binomial.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

namespace obscura::analysis {
namespace {

boost::math::binomial distribution(std::int64_t n, double share) {
    return boost::math::binomial(static_cast<double>(n), share);
}

/// log(1 + r_1 + r_1 r_2 + ...), r_i = (left - i + 1) / (right + i) odds.
double log_of_series(double left, double right, double odds) {
    double sum = 1.0;
    double term = 1.0;
    for (double i = 1.0; i <= left && term > sum * 1e-17; ++i) {
        term *= (left - i + 1.0) / (right + i) * odds;
        sum += term;
    }
    return std::log(sum);
}

}  // namespace

double Binomial::log_pmf(std::int64_t k) const {
    const double pmf = boost::math::pdf(distribution(n_, share_), static_cast<double>(k));
    if (pmf > kSmallestProbability) return std::log(pmf);
    const auto n = static_cast<double>(n_);
    const auto x = static_cast<double>(k);
    using boost::math::lgamma;
    return lgamma(n + 1.0) - lgamma(x + 1.0) - lgamma(n - x + 1.0) + x * std::log(share_) +
           (n - x) * std::log1p(-share_);
}

std::pair<double, double> Binomial::lower(std::int64_t k) const {
    if (k < 0) return {0.0, -std::numeric_limits<double>::infinity()};
    if (k >= n_) return {1.0, 0.0};
    const double p = boost::math::cdf(distribution(n_, share_), static_cast<double>(k));
    if (p > kSmallestProbability) return {p, std::log(p)};
    // P(X = k - 1) / P(X = k) = k (1 - share) / ((n - k + 1) share): far out a falling series.
    return {p, log_pmf(k) + log_of_series(static_cast<double>(k), static_cast<double>(n_ - k),
                                          (1.0 - share_) / share_)};
}

std::pair<double, double> Binomial::upper(std::int64_t k) const {
    if (k > n_) return {0.0, -std::numeric_limits<double>::infinity()};
    if (k <= 0) return {1.0, 0.0};
    const double p = boost::math::cdf(
        boost::math::complement(distribution(n_, share_), static_cast<double>(k - 1)));
    if (p > kSmallestProbability) return {p, std::log(p)};
    return {p, log_pmf(k) + log_of_series(static_cast<double>(n_ - k), static_cast<double>(k),
                                          share_ / (1.0 - share_))};
}

}  // namespace obscura::analysis
