// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Whether participants prefer one side, when each of them voted several times: votes of one
/// participant may hang together, participants do not.
struct SignFlipTest {
    std::int64_t participants = 0;  ///< with more votes for one side than for the other
    std::int64_t sum = 0;           ///< of all differences
    PValue p;                       ///< two-sided
    bool is_exact = true;           ///< over all flips; else by the normal approximation
};

/// Up to so many participants the test is exact.
inline constexpr std::size_t kMostFlipped = 1000;

/// `differences`: for each participant votes for B less votes for A. When nobody prefers a side,
/// each could as well have come with the other sign: p is the share of all flips of signs with a
/// sum at least this far from 0 (R. A. Fisher 1935, section 21; E. J. G. Pitman 1937). With one
/// vote a participant it is the exact binomial test. No value when all are 0. Throws bad input for
/// a difference beyond a million.
[[nodiscard]] Possible<SignFlipTest> sign_flip(const std::vector<std::int64_t>& differences);

/// The same by the normal approximation for differences of any size, as of participants who did not
/// all answer as often; `sum` is rounded. Throws bad input for one that is not finite.
[[nodiscard]] Possible<SignFlipTest> sign_flip_nearly(const std::vector<double>& differences);

}  // namespace obscura::analysis
