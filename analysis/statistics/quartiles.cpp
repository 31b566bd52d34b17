// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/quartiles.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "analysis/statistics/quantile.h"
#include "renderer/base/error.h"

namespace obscura::analysis {

Possible<Quartiles> quartiles(std::vector<double>& sample) {
    if (sample.empty()) return Possible<Quartiles>::none("no values");
    for (const double value : sample) {
        if (!std::isfinite(value)) {
            throw base::bad_input("quartiles: a value is {}, allowed is a finite number", value);
        }
    }
    std::sort(sample.begin(), sample.end());
    return Quartiles{static_cast<std::int64_t>(sample.size()), quantile_of_sorted(sample, 0.25),
                     quantile_of_sorted(sample, 0.5), quantile_of_sorted(sample, 0.75)};
}

Possible<Interval> median_interval(const std::vector<double>& sorted, double confidence) {
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input("median_interval: confidence is {}, allowed is between 0 and 1",
                              confidence);
    }
    if (sorted.empty()) return Possible<Interval>::none("no values");
    const auto n = static_cast<double>(sorted.size());
    const double tail = (1.0 - confidence) / 2.0;
    // The k-th from below is above the median when fewer than k of n fall below it.
    const boost::math::binomial below(n, 0.5);
    auto k = static_cast<std::int64_t>(std::floor(boost::math::quantile(below, tail)));
    while (k > 0 && boost::math::cdf(below, static_cast<double>(k - 1)) > tail) --k;
    while (boost::math::cdf(below, static_cast<double>(k)) <= tail) ++k;
    if (k == 0) return Possible<Interval>::none("too few values");
    const auto place = static_cast<std::size_t>(k);
    return Interval{sorted[place - 1], sorted[sorted.size() - place]};
}

Possible<double> median_slope(const std::vector<std::pair<double, double>>& points) {
    std::vector<double> slopes;
    const auto add = [&](std::size_t one, std::size_t other) {
        const double run = points[other].first - points[one].first;
        if (run != 0.0) slopes.push_back((points[other].second - points[one].second) / run);
    };
    const std::size_t n = points.size();
    if (n <= kMostPaired) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) add(i, j);
        }
    } else {
        for (std::size_t i = 0; i < n / 2; ++i) add(i, i + (n + 1) / 2);
    }
    if (slopes.empty()) return Possible<double>::none("no two points differ in x");
    std::sort(slopes.begin(), slopes.end());
    return quantile_of_sorted(slopes, 0.5);
}

}  // namespace obscura::analysis
