// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/statistics/chi_square.h"

namespace obscura::tests {

/// A table of two rows: a b over c d.
struct TwoByTwo {
    double a, b, c, d;
};

/// The test of N. Mantel and W. Haenszel 1959 over tables, one a stratum, as R's mantelhaen.test:
/// what a study may be compared with, and no part of its analysis.
struct MantelHaenszel {
    double corrected = 0.0, p_corrected = 1.0, p_uncorrected = 1.0, odds_ratio = 0.0;
    double sum = 0.0;      ///< of a over the tables
    double p_exact = 1.0;  ///< of the conditional distribution of the sum
};

/// The chances of the upper left cell, from its smallest value on, with the margins held.
inline std::vector<double> hypergeometric(const TwoByTwo& table, double& lowest) {
    const double row = table.a + table.b;
    const double other = table.c + table.d;
    const double column = table.a + table.c;
    lowest = std::max(0.0, column - other);
    std::vector<double> chances;
    const auto log_choose = [](double n, double k) {
        return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
    };
    for (double a = lowest; a <= std::min(row, column); a += 1.0) {
        chances.push_back(std::exp(log_choose(row, a) + log_choose(other, column - a) -
                                   log_choose(row + other, column)));
    }
    return chances;
}

inline MantelHaenszel mantel_haenszel(const std::vector<TwoByTwo>& tables, bool exact) {
    MantelHaenszel test;
    double off = 0.0, variance = 0.0, with = 0.0, against = 0.0, lowest_sum = 0.0;
    std::vector<double> chances{1.0};
    for (const TwoByTwo& table : tables) {
        const double n = table.a + table.b + table.c + table.d;
        if (n < 2.0) continue;
        const double row = table.a + table.b;
        const double column = table.a + table.c;
        test.sum += table.a;
        off += table.a - row * column / n;
        variance += row * (n - row) * column * (n - column) / (n * n * (n - 1.0));
        with += table.a * table.d / n;
        against += table.b * table.c / n;
        if (!exact) continue;
        double lowest = 0.0;
        const std::vector<double> own = hypergeometric(table, lowest);
        lowest_sum += lowest;
        std::vector<double> next(chances.size() + own.size() - 1);
        for (std::size_t i = 0; i < chances.size(); ++i) {
            for (std::size_t k = 0; k < own.size(); ++k) next[i + k] += chances[i] * own[k];
        }
        chances.swap(next);
    }
    if (variance == 0.0) return test;
    const double less = std::max(0.0, std::abs(off) - .5);
    test.corrected = less * less / variance;
    test.p_corrected = analysis::chi_square_tail(test.corrected, 1).p;
    test.p_uncorrected = analysis::chi_square_tail(off * off / variance, 1).p;
    test.odds_ratio = with / against;
    if (!exact) return test;
    const double met = chances[static_cast<std::size_t>(test.sum - lowest_sum)] * (1.0 + 1e-7);
    test.p_exact = 0.0;
    for (const double chance : chances) test.p_exact += chance <= met ? chance : 0.0;
    return test;
}

}  // namespace obscura::tests
