// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/cochran_q.h"

#include <numeric>

#include "renderer/base/error.h"

namespace obscura::analysis {

void CochranSums::add(std::span<const signed char> row) {
    if (row.size() != yes_.size()) {
        throw base::bad_input("cochran_q: a row has {} answers, allowed are {} as in the first",
                              row.size(), yes_.size());
    }
    double yes = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        yes_[i] += row[i];
        yes += row[i];
    }
    ++rows_;
    mixed_ += yes * (static_cast<double>(row.size()) - yes);
}

Possible<ChiSquareTest> cochran_q(const CochranSums& sums) {
    using None = Possible<ChiSquareTest>;
    if (sums.rows_ == 0) return None::none("no participants");
    if (sums.yes_.size() < 2) return None::none("fewer than two conditions");
    if (sums.mixed_ == 0.0) {
        return None::none("every participant answered alike under all conditions");
    }
    const auto k = static_cast<double>(sums.yes_.size());
    const auto total =
        static_cast<double>(std::accumulate(sums.yes_.begin(), sums.yes_.end(), std::int64_t{0}));
    double off = 0.0;
    for (const std::int64_t yes : sums.yes_) {
        const double difference = static_cast<double>(yes) - total / k;
        off += difference * difference;
    }
    const double statistic = k * (k - 1.0) * off / sums.mixed_;
    const int df = static_cast<int>(sums.yes_.size()) - 1;
    return ChiSquareTest{statistic, df, chi_square_tail(statistic, df)};
}

Possible<ChiSquareTest> cochran_q(const std::vector<std::vector<bool>>& rows) {
    if (rows.empty()) return Possible<ChiSquareTest>::none("no participants");
    CochranSums sums(rows.front().size());
    for (const std::vector<bool>& row : rows) {
        sums.add(std::vector<signed char>(row.begin(), row.end()));
    }
    return cochran_q(sums);
}

}  // namespace obscura::analysis
