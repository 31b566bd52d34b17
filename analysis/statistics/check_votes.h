// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "analysis/statistics/possible.h"
#include "renderer/base/check.h"

namespace obscura::analysis {

/// Throws bad input, naming the function, unless both counts are 0 to kMaxCount.
inline void check_votes(std::string_view where, const Votes& votes) {
    base::check_range(where, "count_a", votes.a, std::int64_t{0}, kMaxCount);
    base::check_range(where, "count_b", votes.b, std::int64_t{0}, kMaxCount);
}

}  // namespace obscura::analysis
