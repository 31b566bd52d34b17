// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace obscura::analysis {

/// The value below which a share of the sorted, non-empty sample lies, between neighbours by their
/// distance (type 7 of R. J. Hyndman and Y. Fan 1996). `share` 0 to 1.
[[nodiscard]] double quantile_of_sorted(const std::vector<double>& sorted, double share);

/// The same of a sample in any order, which it leaves in another: faster than sorting it.
[[nodiscard]] double quantile(std::vector<double>& sample, double share);

}  // namespace obscura::analysis
