// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// y = c x^exponent, fitted by least squares on logarithms, with the 95 % interval of the exponent
/// by Student's t with n - 2 degrees of freedom.
struct PowerLaw {
    double exponent = 0.0;
    double low = 0.0;
    double high = 0.0;
    double r_squared = 0.0;  ///< share of the variance of log y
};

/// Of at least three points with positive, finite values and at least two different x; else the
/// reason why there is none. Throws bad input where the lengths differ.
[[nodiscard]] Possible<PowerLaw> power_law(std::span<const double> x, std::span<const double> y);

/// How one technique's cost grows with one quantity.
struct Growth {
    std::string technique;
    std::string quantity;  ///< pixels or samples
    std::string device;
    std::vector<double> x;
    std::vector<double> ms;  ///< of the accessibility pass; as many as x
    Possible<PowerLaw> law = PowerLaw{};
};

/// technique,quantity,x,ms,exponent,low,high,device: one row a point.
[[nodiscard]] std::string growth_csv(const std::vector<Growth>& growths);

}  // namespace obscura::analysis
