// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/cohens_g.h"

#include "analysis/statistics/check_votes.h"

namespace obscura::analysis {

Possible<double> cohens_g(const Votes& votes) {
    check_votes("cohens_g", votes);
    if (votes.n() == 0) return Possible<double>::none("no votes");
    return static_cast<double>(votes.b - votes.a) / (2.0 * static_cast<double>(votes.n()));
}

}  // namespace obscura::analysis
