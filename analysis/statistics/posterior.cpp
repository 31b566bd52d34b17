// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/posterior.h"

#include <boost/math/distributions/beta.hpp>
#include <numbers>

#include "analysis/statistics/binomial.h"
#include "renderer/base/check.h"

namespace obscura::analysis {

Possible<Posterior> posterior_flat(std::int64_t successes, std::int64_t n, double confidence) {
    base::check_range("posterior_flat", "n", n, std::int64_t{0}, 2 * kMaxCount);
    base::check_range("posterior_flat", "successes", successes, std::int64_t{0}, n);
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input(
            "posterior_flat: confidence is {}, allowed is more than 0 and less than 1", confidence);
    }
    if (n == 0) return Possible<Posterior>::none("no votes");
    const auto alpha = static_cast<double>(successes + 1);
    const auto beta = static_cast<double>(n - successes + 1);
    const boost::math::beta_distribution<> distribution(alpha, beta);
    const double tail = (1.0 - confidence) / 2.0;
    Posterior posterior;
    posterior.mean = alpha / (alpha + beta);
    posterior.interval = {boost::math::quantile(distribution, tail),
                          boost::math::quantile(boost::math::complement(distribution, tail))};
    // P(Beta(a, b) > x) = P(Binomial(a + b - 1, x) <= a - 1) (NIST DLMF 8.17.5).
    const auto [p, log_p] = Binomial(n + 1, 0.5).lower(successes);
    posterior.above_half = {p, log_p / std::numbers::ln10};
    return posterior;
}

}  // namespace obscura::analysis
