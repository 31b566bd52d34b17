// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/order/williams.h"

#include "renderer/base/check.h"

namespace obscura::stimuli {

std::vector<Square> williams_squares(int n) {
    base::check_range("williams design", "order", n, 1, kMostConditions);
    std::vector<int> first(n);
    for (int column = 1; column < n; ++column) {
        // 0, then alternately the smallest and the largest that is left: 1, n-1, 2, n-2, ...
        first[column] = column % 2 == 1 ? (column + 1) / 2 : n - column / 2;
    }
    Square square;
    for (int row = 0; row < n; ++row) {
        square.push_back(first);
        for (int& condition : square.back()) condition = (condition + row) % n;
    }
    if (n % 2 == 0 || n == 1) return {square};
    Square reversed;
    for (const std::vector<int>& row : square) reversed.emplace_back(row.rbegin(), row.rend());
    return {square, reversed};
}

NeighbourCounts count_neighbours(const std::vector<std::vector<int>>& rows, int n) {
    NeighbourCounts counts(n, std::vector<long long>(n, 0));
    for (const std::vector<int>& row : rows) {
        for (std::size_t i = 1; i < row.size(); ++i) ++counts[row[i - 1]][row[i]];
    }
    return counts;
}

}  // namespace obscura::stimuli
