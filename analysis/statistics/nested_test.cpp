// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/nested_test.h"

#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>

#include "renderer/base/check.h"

namespace obscura::analysis {

NestedTest nested_test(double statistic, int df, std::int64_t answers, std::int64_t participants) {
    constexpr const char* kName = "nested_test";
    base::check_range(kName, "statistic", statistic, 0.0, std::numeric_limits<double>::max());
    base::check_range(kName, "df", df, 1, std::numeric_limits<int>::max());
    NestedTest test{statistic, df, answers - participants - df, {}};
    base::check_range(kName, "answers - participants - df", static_cast<double>(test.error_df), 1.0,
                      static_cast<double>(kMaxCount));
    const boost::math::fisher_f_distribution<double> f(df, static_cast<double>(test.error_df));
    test.p.p = boost::math::cdf(boost::math::complement(f, statistic / df));
    test.p.log10_p = std::log10(test.p.p);
    return test;
}

}  // namespace obscura::analysis
