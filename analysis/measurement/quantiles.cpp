// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/quantiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace obscura::analysis {

double quantile(std::vector<double> values, double q) {
    assert(!values.empty() && q >= 0.0 && q <= 1.0);
    const double place = q * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto at = [&values](std::size_t rank) {
        std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank),
                         values.end());
        return values[rank];
    };
    const double low = at(below);
    if (below + 1 == values.size()) return low;
    const double high = at(below + 1);
    return low + (place - static_cast<double>(below)) * (high - low);
}

TimeSummary summary_of(const std::vector<double>& times_ms) {
    if (times_ms.empty()) return {};
    return {quantile(times_ms, 0.0), quantile(times_ms, 0.5), quantile(times_ms, 0.95)};
}

}  // namespace obscura::analysis
