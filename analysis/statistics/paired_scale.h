// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// The largest number of things that are put on one scale.
inline constexpr std::size_t kMaxScaled = 500;

/// How often one thing was chosen over another. `order_side` 1: `one` was shown second, -1: shown
/// first, 0: not known; only a fit with an order term looks at it.
struct PairVotes {
    std::size_t one = 0;  ///< place in the list of things
    std::size_t other = 0;
    std::int64_t one_chosen = 0;  ///< 0 to kMaxCount
    std::int64_t other_chosen = 0;
    int order_side = 0;
};

/// Values of all things on one scale, against the reference, which has 0 and standard error 0.
struct Scale {
    std::vector<double> values;
    std::vector<double> standard_errors;
    double log_likelihood = 0.0;  ///< of the votes in their pairs, without the binomial coefficient
    /// The order term, where one was asked for; see OrderBiasTest.
    double order_term = 0.0;
    double order_standard_error = 0.0;
};

/// What turns a difference on the scale into the share of choices.
enum class ScaleLink {
    kLogistic,  ///< Bradley-Terry: share = 1 / (1 + e^-difference)
    kJod,       ///< Thurstone V: share = Phi(difference q), q = Phi^-1(3/4)
};

struct ScaleOptions {
    ScaleLink link = ScaleLink::kLogistic;
    std::size_t reference = 0;
    bool order_term = false;
    /// Above 0: each difference between two things that a pair compares, and the order term, is
    /// thought to be normal around 0 with this standard deviation before the votes. The scale is
    /// then the likeliest after them (maximum a posteriori), which separated votes have too; its
    /// standard errors are the posterior's.
    double prior_sd = 0.0;
};

/// A vote of a participant: for a place in the list of pairs.
struct PairVote {
    std::size_t pair = 0;
    bool one_chosen = false;
};

/// The votes of participants, one participant after another.
struct VotesOfEach {
    std::vector<PairVote> votes;
    std::vector<std::size_t> begin{0};  ///< of each participant's votes, and the end
};

/// The groups of things that pairs with votes connect, each in the order of `count` things; things
/// of different groups have no common scale.
[[nodiscard]] std::vector<std::vector<std::size_t>> connected_groups(
    std::size_t count, const std::vector<PairVotes>& pairs);

/// The maximum-likelihood scale by Fisher's scoring. No value when the pairs do not connect all
/// things, when without a prior some were always chosen over the others (L. R. Ford 1957: then no
/// finite scale is likeliest), or when an order term was asked for that the votes do not settle;
/// the reason names the things. Throws bad input for counts, places or a reference outside their
/// range, a pair of one thing with itself, and more than kMaxScaled things.
[[nodiscard]] Possible<Scale> fit_scale(const std::vector<std::string>& things,
                                        const std::vector<PairVotes>& pairs,
                                        const ScaleOptions& options);

/// The same scale with standard errors that let the votes of a participant hang together: the
/// sandwich over participants (K.-Y. Liang and S. L. Zeger 1986) with n / (n - 1). `pairs` and
/// `options` are those of the fit. No value for fewer than two participants with votes. Throws bad
/// input for a vote outside the pairs.
[[nodiscard]] Possible<Scale> with_participants_errors(const Scale& scale,
                                                       const std::vector<PairVotes>& pairs,
                                                       const ScaleOptions& options,
                                                       const VotesOfEach& each);

}  // namespace obscura::analysis
