// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/holm.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "renderer/base/check.h"

namespace obscura::analysis {

std::vector<double> holm(const std::vector<double>& p_values) {
    for (const double p : p_values) base::check_range("holm", "p", p, 0.0, 1.0);
    std::vector<std::size_t> rank(p_values.size());
    std::iota(rank.begin(), rank.end(), std::size_t{0});
    std::stable_sort(rank.begin(), rank.end(), [&](std::size_t one, std::size_t other) {
        return p_values[one] < p_values[other];
    });
    std::vector<double> adjusted(p_values.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < rank.size(); ++i) {
        const auto tests_left = static_cast<double>(rank.size() - i);
        largest = std::max(largest, std::min(1.0, tests_left * p_values[rank[i]]));
        adjusted[rank[i]] = largest;
    }
    return adjusted;
}

}  // namespace obscura::analysis
