// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/mcnemar.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/check_votes.h"
#include "analysis/statistics/exact_binomial.h"

namespace obscura::analysis {

Possible<McNemarTest> mcnemar(const Votes& changed) {
    check_votes("mcnemar", changed);
    if (changed.n() == 0) {
        return Possible<McNemarTest>::none("no participant changed the answer");
    }
    McNemarTest test;
    test.discordant = changed.n();
    test.uncorrected = *chi_square_equal_split(changed);
    const double off = std::max(0.0, std::abs(static_cast<double>(changed.b - changed.a)) - 1.0);
    test.corrected.statistic = off * off / static_cast<double>(changed.n());
    test.corrected.p = chi_square_tail(test.corrected.statistic, 1);
    test.exact = *exact_binomial(changed.b, changed.n());
    return test;
}

}  // namespace obscura::analysis
