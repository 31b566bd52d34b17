// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/order/balance.h"

#include <algorithm>
#include <set>

#include "renderer/base/check.h"
#include "stimuli/order/latin_square.h"

namespace obscura::stimuli {

bool Balance::columns_hold() const {
    return latin_squares == squares && sessions == squares * condition_count;
}

bool Balance::sides_hold_in_sessions() const {
    const auto n = static_cast<std::size_t>(condition_count);
    for (std::size_t first = 0; first <= n; ++first) {
        const bool is_half = first == n / 2 || first == n - n / 2;
        if (!is_half && sessions_with_a_first[first] > 0) return false;
    }
    return true;
}

bool Balance::neighbours_hold() const {
    const CountRange range = range_off_diagonal(neighbours);
    return range.low == range.high;
}

Balance balance_of(const std::vector<SessionOrder>& sessions, int condition_count) {
    base::check_range("balance", "number of conditions", condition_count, 1, kMostConditions);
    const auto n = static_cast<std::size_t>(condition_count);
    Balance balance;
    balance.condition_count = condition_count;
    balance.sessions = sessions.size();
    balance.at_position.assign(n, std::vector<long long>(n, 0));
    balance.a_first.assign(n, 0);
    balance.b_first.assign(n, 0);
    balance.sessions_with_a_first.assign(n + 1, 0);
    balance.neighbours.assign(n, std::vector<long long>(n, 0));
    Square square;
    for (const SessionOrder& session : sessions) {
        const std::vector<int>& row = session.conditions;
        const bool complete = row.size() == n && std::set<int>(row.begin(), row.end()).size() == n;
        balance.complete_rows += complete ? 1 : 0;
        std::size_t a_first = 0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i < n) ++balance.at_position[row[i]][i];
            ++(session.b_first(i) ? balance.b_first : balance.a_first)[row[i]];
            if (!session.b_first(i)) ++a_first;
            if (i > 0) ++balance.neighbours[row[i - 1]][row[i]];
        }
        ++balance.sessions_with_a_first.at(std::min(a_first, n));
        square.push_back(row);
        if (square.size() < n) continue;
        ++balance.squares;
        balance.latin_squares += is_latin(square) ? 1 : 0;
        square.clear();
    }
    return balance;
}

CountRange range_off_diagonal(const NeighbourCounts& counts) {
    if (counts.size() < 2) return {};
    CountRange range{counts[0][1], counts[0][1]};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        for (std::size_t j = 0; j < counts.size(); ++j) {
            if (i == j) continue;
            range.low = std::min(range.low, counts[i][j]);
            range.high = std::max(range.high, counts[i][j]);
        }
    }
    return range;
}

}  // namespace obscura::stimuli
