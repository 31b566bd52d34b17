// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace obscura::analysis {

/// A number that may be varied.
struct Unknown {
    std::string name;
    double low = 0.0;          ///< smallest value tried
    double high = 1.0;         ///< largest value tried, > low
    double start = 0.5;        ///< where the first search begins, low to high
    bool logarithmic = false;  ///< steps are factors; low must be above 0
};

struct MinimiseOptions {
    int starts = 4;           ///< searches: the first from `start`, the others from random points
    int scouts = 0;           ///< random points that are looked at before: the first search begins
                              ///< at the best of them and `start`, which may lie on a plain
    int evaluations = 60;     ///< of the function, for each search
    double tolerance = 1e-3;  ///< a search ends where the unknowns move less, of their ranges
    std::uint64_t seed = 1;   ///< of the random starting points
};

struct Minimum {
    std::vector<double> values;  ///< one for each unknown
    double smallest = 0.0;       ///< the function there
    double at_start = 0.0;       ///< the function at the first start
    int evaluations = 0;
};

/// The smallest value of `function` that NLopt's Subplex (SBPLX, Rowan 1990; it needs no
/// derivatives and stands steps and noise) finds from several starts. A value of the function that
/// is not finite counts as very large. The same seed gives the same answer; never worse than
/// `start`. Throws bad input naming the unknown for a range that is none.
[[nodiscard]] Minimum minimise(const std::vector<Unknown>& unknowns,
                               const std::function<double(std::span<const double>)>& function,
                               const MinimiseOptions& options = {});

}  // namespace obscura::analysis
