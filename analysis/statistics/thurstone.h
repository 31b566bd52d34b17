// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/paired_scale.h"

namespace obscura::analysis {

/// L. L. Thurstone's law of comparative judgement, Case V (1927), by maximum likelihood, in just
/// objectionable differences: a thing 1 JOD above another is chosen by 75 % (M. Perez-Ortiz and
/// R. K. Mantiuk 2017). `reference` has value 0. Values, errors and reasons as fit_scale.
[[nodiscard]] Possible<Scale> thurstone_jod(const std::vector<std::string>& things,
                                            const std::vector<PairVotes>& pairs,
                                            std::size_t reference = 0);

}  // namespace obscura::analysis
