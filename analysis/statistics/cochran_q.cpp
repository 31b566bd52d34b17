// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/cochran_q.h"

#include <algorithm>

#include "renderer/base/error.h"

namespace obscura::analysis {

Possible<ChiSquareTest> cochran_q(const std::vector<std::vector<bool>>& rows) {
    if (rows.empty()) return Possible<ChiSquareTest>::none("no participants");
    const std::size_t conditions = rows.front().size();
    std::vector<std::int64_t> by_condition(conditions);
    double total = 0.0;
    double mixed = 0.0;  // sum of L (k - L), which is 0 for answers all alike
    for (const std::vector<bool>& row : rows) {
        if (row.size() != conditions) {
            throw base::bad_input("cochran_q: a row has {} answers, allowed are {} as in the first",
                                  row.size(), conditions);
        }
        for (std::size_t i = 0; i < conditions; ++i) by_condition[i] += row[i] ? 1 : 0;
        const auto yes = static_cast<double>(std::count(row.begin(), row.end(), true));
        total += yes;
        mixed += yes * (static_cast<double>(conditions) - yes);
    }
    if (conditions < 2) return Possible<ChiSquareTest>::none("fewer than two conditions");
    if (mixed == 0.0) {
        return Possible<ChiSquareTest>::none(
            "every participant answered alike under all conditions");
    }
    const auto k = static_cast<double>(conditions);
    double off = 0.0;
    for (const std::int64_t yes : by_condition) {
        const double difference = static_cast<double>(yes) - total / k;
        off += difference * difference;
    }
    const double statistic = k * (k - 1.0) * off / mixed;
    const int df = static_cast<int>(conditions) - 1;
    return ChiSquareTest{statistic, df, chi_square_tail(statistic, df)};
}

}  // namespace obscura::analysis
