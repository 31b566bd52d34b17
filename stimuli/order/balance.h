// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "stimuli/order/order.h"
#include "stimuli/order/williams.h"

namespace obscura::stimuli {

/// What a sequence of sessions balances, by counting: nothing is taken from how it was made.
/// Tables have one row a condition, numbered as in the study.
struct Balance {
    int condition_count = 0;
    std::uint64_t sessions = 0;
    /// Sessions that show every condition exactly once.
    std::uint64_t complete_rows = 0;
    /// Runs of n successive sessions from slot 0, n, 2n, ... that are there in full, and how many
    /// of them show every condition once at each position.
    std::uint64_t squares = 0;
    std::uint64_t latin_squares = 0;
    std::vector<std::vector<long long>> at_position;  ///< [condition][position], n x n
    std::vector<long long> a_first;                   ///< sessions with image A first
    std::vector<long long> b_first;
    /// Sessions by how many of their pairs have image A first: 0 .. n.
    std::vector<long long> sessions_with_a_first;
    NeighbourCounts neighbours;  ///< [left][right]: how often right came directly after left

    /// Every condition once in each session.
    [[nodiscard]] bool rows_hold() const { return complete_rows == sessions; }
    /// Every condition once at each position of every square, and none is left unfinished.
    [[nodiscard]] bool columns_hold() const;
    /// Every image of a pair was first as often as the other.
    [[nodiscard]] bool sides_hold() const { return a_first == b_first; }
    /// Each side first in half of the pairs of every session, one more or less where they are odd.
    [[nodiscard]] bool sides_hold_in_sessions() const;
    /// Every condition came directly after every other one equally often.
    [[nodiscard]] bool neighbours_hold() const;
};

/// Counts over sessions of 0 .. condition_count - 1, in order of their slots from 0.
[[nodiscard]] Balance balance_of(const std::vector<SessionOrder>& sessions, int condition_count);

/// Smallest and largest count of how often a condition came after another one; 0, 0 for one
/// condition.
struct CountRange {
    long long low = 0;
    long long high = 0;
};
[[nodiscard]] CountRange range_off_diagonal(const NeighbourCounts& counts);

}  // namespace obscura::stimuli
