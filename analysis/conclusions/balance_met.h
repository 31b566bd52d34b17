// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/tally.h"

namespace obscura::analysis {

/// How even the counts of a table came out.
struct Evenness {
    std::int64_t low = 0;
    std::int64_t high = 0;
    double even = 0.0;  ///< what each would be
};

/// Where the pairs stood in the sessions that came, counted and not taken from the plan.
struct BalanceMet {
    std::string unknown;  ///< why nothing is known; empty where the rest has values
    Evenness at_place;    ///< how often each pair was at each place that votes had
    Evenness after;       ///< how often each pair came directly after each other one
};

/// Neighbours are votes with one number of the trial after the other. Linear in the votes, and
/// quadratic in the conditions.
[[nodiscard]] BalanceMet balance_met(const Tally& tally);

}  // namespace obscura::analysis
