// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/thurstone.h"

namespace obscura::analysis {

Possible<Scale> thurstone_jod(const std::vector<std::string>& things,
                              const std::vector<PairVotes>& pairs, std::size_t reference) {
    return fit_scale(things, pairs, {ScaleLink::kJod, reference, false});
}

}  // namespace obscura::analysis
