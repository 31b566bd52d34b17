// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/statistics/quartiles.h"

namespace obscura::analysis {

/// An interval of the share of B in a second condition less that in a first, -1 to 1, where the
/// same `n` participants answered both: `changed.a` of them went from B to A, `changed.b` from A to
/// B. From the exact (Clopper-Pearson) limits of the two shares of changes by the method of
/// variance estimates recovery (G. Y. Zou and A. Donner 2008, Statistics in Medicine 27, 1693) with
/// their multinomial correlation, of the shares with half a change added either way. It is no point
/// where nobody changed: its ends are then the exact upper limit of a change either way, .308 for
/// ten participants. No value for n = 0. Throws bad input for counts outside 0 to kMaxCount, more
/// changes than participants and a confidence that is not strictly between 0 and 1.
[[nodiscard]] Possible<Interval> paired_difference(const Votes& changed, std::int64_t n,
                                                   double confidence = 0.95);

}  // namespace obscura::analysis
