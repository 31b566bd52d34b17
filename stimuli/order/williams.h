// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stimuli/order/order.h"

namespace obscura::stimuli {

/// The Williams design of order n (Williams 1949): Latin squares in which every condition comes
/// directly after every other one equally often. The first row is 1, 2, n, 3, n-1, ... (here from
/// 0), each further row adds 1 modulo n. Even n: one square, each neighbourhood once. Odd n: two
/// squares, the second with the rows of the first reversed, each neighbourhood twice in all.
/// Throws bad input unless n is 1 to kMostConditions.
[[nodiscard]] std::vector<Square> williams_squares(int n);

/// How often each condition came directly after each other one: entry [left][right], n x n.
using NeighbourCounts = std::vector<std::vector<long long>>;
[[nodiscard]] NeighbourCounts count_neighbours(const std::vector<std::vector<int>>& rows, int n);

}  // namespace obscura::stimuli
