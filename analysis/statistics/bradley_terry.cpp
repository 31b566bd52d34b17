// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/bradley_terry.h"

namespace obscura::analysis {

Possible<Scale> bradley_terry(const std::vector<std::string>& things,
                              const std::vector<PairVotes>& pairs, std::size_t reference) {
    return fit_scale(things, pairs, {ScaleLink::kLogistic, reference, false});
}

Possible<Scale> bradley_terry_with_order(const std::vector<std::string>& things,
                                         const std::vector<PairVotes>& pairs,
                                         std::size_t reference) {
    return fit_scale(things, pairs, {ScaleLink::kLogistic, reference, true});
}

}  // namespace obscura::analysis
