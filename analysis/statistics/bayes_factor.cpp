// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/bayes_factor.h"

#include <cmath>
#include <numbers>

#include "analysis/statistics/binomial.h"
#include "renderer/base/check.h"

namespace obscura::analysis {

Possible<BayesFactor> bayes_factor(std::int64_t successes, std::int64_t n) {
    base::check_range("bayes_factor", "n", n, std::int64_t{0}, 2 * kMaxCount);
    base::check_range("bayes_factor", "successes", successes, std::int64_t{0}, n);
    if (n == 0) return Possible<BayesFactor>::none("no votes");
    // Under the flat prior every count of successes is equally likely: 1 / (n + 1).
    const double log_bf10 =
        -std::log(static_cast<double>(n + 1)) - Binomial(n, 0.5).log_pmf(successes);
    BayesFactor factor;
    factor.log10_bf10 = log_bf10 / std::numbers::ln10;
    const double bf10 = std::exp(log_bf10);
    if (std::isfinite(bf10)) factor.bf10 = bf10;
    return factor;
}

}  // namespace obscura::analysis
