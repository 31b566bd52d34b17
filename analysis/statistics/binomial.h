// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <utility>

namespace obscura::analysis {

/// Probabilities below this have lost digits or vanished.
inline constexpr double kSmallestProbability = std::numeric_limits<double>::min() / 1e-16;

/// The binomial distribution (Boost.Math), with tails that keep their size where doubles end.
/// `n` >= 0, `share` strictly between 0 and 1; callers check.
class Binomial {
  public:
    Binomial(std::int64_t n, double share) : n_(n), share_(share) {}

    /// Natural logarithm of P(X = k), k 0 to n.
    [[nodiscard]] double log_pmf(std::int64_t k) const;
    /// P(X <= k) and its natural logarithm; 0 and minus infinity below 0.
    [[nodiscard]] std::pair<double, double> lower(std::int64_t k) const;
    /// P(X >= k) and its natural logarithm; 0 and minus infinity above n.
    [[nodiscard]] std::pair<double, double> upper(std::int64_t k) const;

  private:
    std::int64_t n_;
    double share_;
};

}  // namespace obscura::analysis
