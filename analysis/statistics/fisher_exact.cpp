// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/fisher_exact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/statistics/binomial.h"
#include "analysis/statistics/check_votes.h"

namespace obscura::analysis {
namespace {

/// How many of the votes for B fall into the first row when the sums of a 2x2 table are fixed.
class Hypergeometric {
  public:
    /// `row` and `other` votes in the two rows, `b` votes for B in both.
    Hypergeometric(std::int64_t row, std::int64_t other, std::int64_t b)
        : row_(row),
          other_(other),
          b_(b),
          share_(static_cast<double>(b) / static_cast<double>(row + other)),
          log_both_(Binomial(row + other, share_).log_pmf(b)) {}

    [[nodiscard]] std::int64_t low() const { return std::max(std::int64_t{0}, b_ - other_); }
    [[nodiscard]] std::int64_t high() const { return std::min(row_, b_); }
    [[nodiscard]] std::int64_t mode() const {
        const double place = (static_cast<double>(row_) + 1.0) * (static_cast<double>(b_) + 1.0) /
                             (static_cast<double>(row_ + other_) + 2.0);
        return std::clamp(static_cast<std::int64_t>(place), low(), high());
    }

    /// By binomial probabilities, which lose no digits in large tables.
    [[nodiscard]] double log_pmf(std::int64_t k) const {
        return Binomial(row_, share_).log_pmf(k) + Binomial(other_, share_).log_pmf(b_ - k) -
               log_both_;
    }

    /// log of P(X = k) + P(X = k + step) + ... to the end; `step` is 1 or -1 and leads away from
    /// the mode.
    [[nodiscard]] double log_tail(std::int64_t k, int step) const {
        double sum = 1.0;
        double term = 1.0;
        for (std::int64_t i = k; i != (step > 0 ? high() : low()) && term > sum * 1e-17;
             i += step) {
            term *= step > 0 ? up(i) : 1.0 / up(i - 1);
            sum += term;
        }
        return log_pmf(k) + std::log(sum);
    }

  private:
    /// P(X = k + 1) / P(X = k).
    [[nodiscard]] double up(std::int64_t k) const {
        return static_cast<double>(row_ - k) / static_cast<double>(k + 1) *
               (static_cast<double>(b_ - k) / static_cast<double>(other_ - b_ + k + 1));
    }

    std::int64_t row_;
    std::int64_t other_;
    std::int64_t b_;
    double share_;
    double log_both_;
};

/// The value nearest to the mode, on the side where `step` leads, that is no more likely than
/// `tie`; one step beyond `end` when there is none.
std::int64_t far_edge(const Hypergeometric& table, double tie, std::int64_t end, int step) {
    std::int64_t likely = table.mode();
    std::int64_t edge = end + step;
    while (edge != likely + step) {
        const std::int64_t middle = likely + (edge - likely) / 2;
        (table.log_pmf(middle) <= tie ? edge : likely) = middle;
    }
    return edge;
}

PValue from_log(double log_p) {
    const double capped = std::min(log_p, 0.0);
    return {std::exp(capped), capped / std::numbers::ln10};
}

}  // namespace

Possible<PValue> fisher_exact(const Votes& one, const Votes& other) {
    check_votes("fisher_exact", one);
    check_votes("fisher_exact", other);
    if (one.n() == 0 || other.n() == 0) {
        return Possible<PValue>::none("fewer than two rows have votes");
    }
    if (one.a + other.a == 0 || one.b + other.b == 0) {
        return Possible<PValue>::none("all votes are for one side");
    }
    const Hypergeometric table(one.n(), other.n(), one.b + other.b);
    const double tie = table.log_pmf(one.b) + std::log1p(1e-7);
    if (table.log_pmf(table.mode()) <= tie) return PValue{1.0, 0.0};
    const int near = one.b > table.mode() ? 1 : -1;
    const std::int64_t far_end = near > 0 ? table.low() : table.high();
    const std::int64_t far = far_edge(table, tie, far_end, -near);
    const double log_near = table.log_tail(one.b, near);
    if (far == far_end - near) return from_log(log_near);
    const double log_far = table.log_tail(far, -near);
    const double larger = std::max(log_near, log_far);
    return from_log(larger + std::log1p(std::exp(std::min(log_near, log_far) - larger)));
}

}  // namespace obscura::analysis
