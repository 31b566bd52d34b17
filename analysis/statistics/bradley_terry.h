// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/paired_scale.h"

namespace obscura::analysis {

/// The model of R. A. Bradley and M. E. Terry 1952 by maximum likelihood: log odds of choosing one
/// thing over another are the difference of their values. `reference` has value 0. Values, errors
/// and reasons as fit_scale.
[[nodiscard]] Possible<Scale> bradley_terry(const std::vector<std::string>& things,
                                            const std::vector<PairVotes>& pairs,
                                            std::size_t reference = 0);

/// The same with a term for the order of showing (R. R. Davidson and R. J. Beaver 1977), which
/// needs PairVotes::order_side.
[[nodiscard]] Possible<Scale> bradley_terry_with_order(const std::vector<std::string>& things,
                                                       const std::vector<PairVotes>& pairs,
                                                       std::size_t reference = 0);

}  // namespace obscura::analysis
