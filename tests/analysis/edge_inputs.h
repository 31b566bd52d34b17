// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "analysis/statistics/possible.h"

namespace obscura::tests {

/// The same inputs for every statistic of votes: nothing, one, all on one side, ties, thesis
/// sizes, a billion, the largest that is taken.
inline constexpr std::array kEdgeVotes{
    analysis::Votes{0, 0},
    analysis::Votes{0, 1},
    analysis::Votes{1, 0},
    analysis::Votes{1, 1},
    analysis::Votes{0, 36},
    analysis::Votes{36, 0},
    analysis::Votes{18, 18},
    analysis::Votes{11, 25},
    analysis::Votes{0, 1'000'000'000},
    analysis::Votes{1'000'000'000, 1},
    analysis::Votes{500'000'000, 500'000'000},
    analysis::Votes{500'000'000, 500'100'000},
    analysis::Votes{analysis::kMaxCount, analysis::kMaxCount},
    analysis::Votes{analysis::kMaxCount, 0},
};

/// Counts that no statistic takes.
inline constexpr std::array kImpossibleVotes{
    analysis::Votes{-1, 3},
    analysis::Votes{3, -1},
    analysis::Votes{analysis::kMaxCount + 1, 0},
    analysis::Votes{0, std::numeric_limits<std::int64_t>::max()},
    analysis::Votes{std::numeric_limits<std::int64_t>::min(), 0},
};

inline constexpr std::array kNoProbabilities{-0.1, 1.1, std::numeric_limits<double>::quiet_NaN(),
                                             std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity()};

/// A p-value that can be one, with a logarithm that belongs to it.
inline bool is_proper(const analysis::PValue& p) {
    if (!(p.p >= 0.0 && p.p <= 1.0) || !std::isfinite(p.log10_p) || p.log10_p > 0.0) return false;
    return p.p < 1e-280 ? p.log10_p < -279.0 : std::abs(std::log10(p.p) - p.log10_p) < 1e-9;
}

}  // namespace obscura::tests
