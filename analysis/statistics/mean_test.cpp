// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/mean_test.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "renderer/base/error.h"

namespace obscura::analysis {

Possible<MeanTest> mean_test(const std::vector<double>& values, double confidence) {
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input("mean_test: confidence is {}, allowed is between 0 and 1",
                              confidence);
    }
    MeanTest test;
    for (const double value : values) {
        if (!std::isfinite(value)) {
            throw base::bad_input("mean_test: a value is {}, allowed is a finite number", value);
        }
        test.mean += value;
    }
    if (values.size() < 2) return Possible<MeanTest>::none("fewer than two participants");
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (*low == *high) return Possible<MeanTest>::none("all participants gave the same");
    const auto n = static_cast<double>(values.size());
    test.n = static_cast<std::int64_t>(values.size());
    test.mean /= n;
    double squares = 0.0;
    for (const double value : values) squares += (value - test.mean) * (value - test.mean);
    test.standard_error = std::sqrt(squares / (n - 1.0) / n);
    const boost::math::students_t t(n - 1.0);
    const double statistic = std::abs(test.mean) / test.standard_error;
    test.p.p = std::min(1.0, 2.0 * boost::math::cdf(boost::math::complement(t, statistic)));
    test.p.log10_p = std::log10(test.p.p);
    const double reach = test.standard_error * boost::math::quantile(boost::math::complement(
                                                   t, (1.0 - confidence) / 2.0));
    test.interval = {test.mean - reach, test.mean + reach};
    return test;
}

}  // namespace obscura::analysis
