// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/chi_square.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/fraction.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/statistics/check_votes.h"

namespace obscura::analysis {
namespace {

/// Terms of Legendre's continued fraction for the upper incomplete gamma function (NIST DLMF
/// 8.9.2 in its even form): Gamma(a, x) = x^a e^-x / (x + 1 - a - 1 (1 - a) / (x + 3 - a - ...)).
class GammaFraction {
  public:
    using result_type = std::pair<double, double>;
    GammaFraction(double a, double x) : a_(a), b_(x + 1.0 - a) {}
    result_type operator()() {
        ++k_;
        b_ += 2.0;
        return {k_ * (a_ - k_), b_};
    }

  private:
    double a_;
    double b_;
    double k_ = 0.0;
};

/// Natural logarithm of Q(a, x) for x far beyond a, where Q itself may be too small for a double.
double log_gamma_q(double a, double x) {
    GammaFraction terms(a, x);
    const double rest =
        boost::math::tools::continued_fraction_a(terms, std::numeric_limits<double>::epsilon());
    const double denominator = x + 1.0 - a + rest;
    return a * std::log(x) - x - boost::math::lgamma(a) - std::log(denominator);
}

}  // namespace

PValue chi_square_tail(double statistic, int df) {
    base::check_range("chi_square_tail", "statistic", statistic, 0.0,
                      std::numeric_limits<double>::max());
    base::check_range("chi_square_tail", "df", df, 1, std::numeric_limits<int>::max());
    const double p =
        boost::math::cdf(boost::math::complement(boost::math::chi_squared(df), statistic));
    if (p > std::numeric_limits<double>::min()) return {p, std::log10(p)};
    return {p, log_gamma_q(df / 2.0, statistic / 2.0) / std::numbers::ln10};
}

Possible<ChiSquareTest> chi_square_equal_split(const Votes& votes) {
    check_votes("chi_square_equal_split", votes);
    if (votes.n() == 0) return Possible<ChiSquareTest>::none("no votes");
    const auto difference = static_cast<double>(votes.b - votes.a);
    const double statistic = difference * difference / static_cast<double>(votes.n());
    return ChiSquareTest{statistic, 1, chi_square_tail(statistic, 1)};
}

Possible<ChiSquareTest> chi_square_homogeneity(const std::vector<Votes>& rows) {
    Votes total;
    int kept = 0;
    for (const Votes& row : rows) {
        check_votes("chi_square_homogeneity", row);
        total.a += row.a;
        total.b += row.b;
        if (row.n() > 0) ++kept;
    }
    if (kept < 2) return Possible<ChiSquareTest>::none("fewer than two rows have votes");
    if (total.a == 0 || total.b == 0) {
        return Possible<ChiSquareTest>::none("all votes are for one side");
    }
    // With two columns both cells of a row are off by the same amount d, so that a row adds
    // d^2 (1 / E_a + 1 / E_b) = d^2 N^2 / (n A B).
    const auto share_b = static_cast<double>(total.b) / static_cast<double>(total.n());
    const auto share_a = static_cast<double>(total.a) / static_cast<double>(total.n());
    double statistic = 0.0;
    for (const Votes& row : rows) {
        if (row.n() == 0) continue;
        const double n = static_cast<double>(row.n());
        const double off =
            static_cast<double>(row.b) * share_a - static_cast<double>(row.a) * share_b;
        statistic += off * off / (n * share_a * share_b);
    }
    return ChiSquareTest{statistic, kept - 1, chi_square_tail(statistic, kept - 1)};
}

}  // namespace obscura::analysis
