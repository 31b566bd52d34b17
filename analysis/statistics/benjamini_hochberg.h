// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace obscura::analysis {

/// The step-up correction of Y. Benjamini and Y. Hochberg 1995: the p-values of a family of tests,
/// adjusted so that the expected share of false ones among the rejections stays at the level. Same
/// order as given. Throws bad input for one outside 0 to 1 or NaN; an empty family is an empty
/// answer.
[[nodiscard]] std::vector<double> benjamini_hochberg(const std::vector<double>& p_values);

}  // namespace obscura::analysis
