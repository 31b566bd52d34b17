// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/quantile.h"

#include <algorithm>
#include <cassert>

namespace obscura::analysis {

double quantile_of_sorted(const std::vector<double>& sorted, double share) {
    assert(!sorted.empty() && share >= 0.0 && share <= 1.0);
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double quantile(std::vector<double>& sample, double share) {
    assert(!sample.empty());
    // Only the two neighbours that are read come to their places.
    const auto at = sample.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), at, sample.end());
    if (at + 1 != sample.end()) std::iter_swap(at + 1, std::min_element(at + 1, sample.end()));
    return quantile_of_sorted(sample, share);
}

}  // namespace obscura::analysis
