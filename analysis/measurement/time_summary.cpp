// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/time_summary.h"

#include <algorithm>

#include "analysis/statistics/quantile.h"

namespace obscura::analysis {

TimeSummary summary_of(std::vector<double> times_ms) {
    if (times_ms.empty()) return {};
    std::sort(times_ms.begin(), times_ms.end());
    return {times_ms.front(), quantile_of_sorted(times_ms, 0.5),
            quantile_of_sorted(times_ms, 0.95)};
}

}  // namespace obscura::analysis
