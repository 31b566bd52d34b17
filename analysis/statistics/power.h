// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// The two tests of an equal split that the analysis makes.
enum class SplitTest { kExact, kChiSquare };

/// How a test of an equal split behaves at a number of participants.
struct TestPower {
    std::int64_t n = 0;
    /// Votes for the favoured side from which on (and, mirrored, to which) the test is significant;
    /// nothing when no outcome is.
    Possible<std::int64_t> critical_votes = Possible<std::int64_t>::none("not known");
    double power = 0.0;      ///< chance of a significant result at the true share
    double true_size = 0.0;  ///< the same when the true share is one half
};

/// Largest number of participants that is looked at, 1e9; nearest a share may come to one half when
/// participants are asked for, .001.
inline constexpr std::int64_t kMostParticipants = 1'000'000'000;
inline constexpr double kSmallestEffect = 1e-3;

/// How many more numbers of participants must keep the power: it falls and rises like a saw.
inline constexpr int kStaysForNext = 6;

/// A result is significant when p < `level`. Sums of the binomial distribution, no approximation.
/// `n` 1 to kMostParticipants, `share` and `level` strictly between 0 and 1: throws bad input
/// otherwise.
[[nodiscard]] TestPower power_of(SplitTest test, std::int64_t n, double share, double level);

/// The smallest share above one half at which the power is at least `power`, to 1e-7: it grows with
/// the share. Arguments as of power_of. No value where the participants are too few for any.
[[nodiscard]] Possible<double> detectable_share(SplitTest test, std::int64_t n, double level,
                                                double power);

/// The smallest number of participants whose power is at least `power`, and that of the next
/// kStaysForNext numbers too. `share` at least kSmallestEffect from one half, `level` and `power`
/// strictly between 0 and 1: throws bad input otherwise. No value when it is above
/// kMostParticipants.
[[nodiscard]] Possible<std::int64_t> participants_needed(SplitTest test, double share, double level,
                                                         double power);

}  // namespace obscura::analysis
