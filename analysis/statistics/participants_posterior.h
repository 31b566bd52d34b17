// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/posterior.h"

namespace obscura::analysis {

/// What is believed of the share of B among people, each of whom has a share of his own: beta
/// binomial votes with mean `share` and a correlation between two votes of a participant, when
/// every share and every correlation from 0 to 1 were thought equally likely before (A. Gelman et
/// al. 2013, Bayesian Data Analysis, section 5.3, with another prior). With one vote a participant
/// it is posterior_flat(). By quadrature, not by drawing, to some 1e-6. `each`: the votes of each
/// participant; those without are passed over. No value without votes, and for more than
/// kMostVotedAlike different pairs of counts. Throws bad input for counts outside 0 to kMaxCount
/// and a confidence that is not strictly between 0 and 1.
[[nodiscard]] Possible<Posterior> participants_posterior(const std::vector<Votes>& each,
                                                         double confidence = 0.95);

inline constexpr std::size_t kMostVotedAlike = 300;

}  // namespace obscura::analysis
