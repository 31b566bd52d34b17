// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace obscura::analysis {

/// The share whose log odds are x: 0 to 1, without overflow.
[[nodiscard]] inline double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// log(1 + e^x) without overflow.
[[nodiscard]] inline double log1p_exp(double x) {
    return std::max(x, 0.0) + std::log1p(std::exp(-std::abs(x)));
}

}  // namespace obscura::analysis
