// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace obscura::analysis {

/// Holm's step-down correction (S. Holm 1979): the p-values of a family of tests, adjusted so that
/// the chance of any false rejection stays at the level. Same order as given. Throws bad input for
/// one outside 0 to 1 or NaN; an empty family is an empty answer.
[[nodiscard]] std::vector<double> holm(const std::vector<double>& p_values);

}  // namespace obscura::analysis
