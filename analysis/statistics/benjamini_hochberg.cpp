// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/benjamini_hochberg.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "renderer/base/check.h"

namespace obscura::analysis {

std::vector<double> benjamini_hochberg(const std::vector<double>& p_values) {
    for (const double p : p_values) base::check_range("benjamini_hochberg", "p", p, 0.0, 1.0);
    std::vector<std::size_t> rank(p_values.size());
    std::iota(rank.begin(), rank.end(), std::size_t{0});
    std::stable_sort(rank.begin(), rank.end(), [&](std::size_t one, std::size_t other) {
        return p_values[one] < p_values[other];
    });
    std::vector<double> adjusted(p_values.size());
    const auto tests = static_cast<double>(rank.size());
    double smallest = 1.0;
    for (std::size_t i = rank.size(); i-- > 0;) {
        smallest = std::min(smallest, p_values[rank[i]] * tests / static_cast<double>(i + 1));
        adjusted[rank[i]] = smallest;
    }
    return adjusted;
}

}  // namespace obscura::analysis
