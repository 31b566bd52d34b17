// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/growth.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "analysis/table/csv.h"
#include "analysis/text/text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {

Possible<PowerLaw> power_law(std::span<const double> x, std::span<const double> y) {
    using None = Possible<PowerLaw>;
    if (x.size() != y.size()) {
        throw base::bad_input("power law: {} values of x and {} of y", x.size(), y.size());
    }
    if (x.size() < 3) return None::none("an interval needs at least three points");
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!std::all_of(x.begin(), x.end(), positive) || !std::all_of(y.begin(), y.end(), positive)) {
        return None::none("a logarithm needs values above 0");
    }
    const auto n = static_cast<double>(x.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / n;
        mean_y += std::log(y[i]) / n;
    }
    double sxx = 0.0;
    double sxy = 0.0;
    double syy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - mean_x;
        const double dy = std::log(y[i]) - mean_y;
        sxx += dx * dx;
        sxy += dx * dy;
        syy += dy * dy;
    }
    if (!(sxx > 1e-12)) return None::none("all points have the same x");
    PowerLaw law;
    law.exponent = sxy / sxx;
    const double left = std::max(0.0, syy - law.exponent * sxy);
    const boost::math::students_t t(n - 2.0);
    const double half = boost::math::quantile(boost::math::complement(t, 0.025)) *
                        std::sqrt(left / (n - 2.0) / sxx);
    law.low = law.exponent - half;
    law.high = law.exponent + half;
    law.r_squared = syy > 0.0 ? 1.0 - left / syy : 1.0;
    return law;
}

std::string growth_csv(const std::vector<Growth>& growths) {
    std::string text =
        csv_line({"technique", "quantity", "x", "ms", "exponent", "low", "high", "device"});
    for (const Growth& growth : growths) {
        const bool has = growth.law.has_value();
        for (std::size_t i = 0; i < growth.x.size(); ++i) {
            text += csv_line({growth.technique, growth.quantity, shortest(growth.x[i]),
                              shortest(growth.ms[i]), has ? shortest(growth.law->exponent) : "",
                              has ? shortest(growth.law->low) : "",
                              has ? shortest(growth.law->high) : "", growth.device});
        }
    }
    return text;
}

}  // namespace obscura::analysis
