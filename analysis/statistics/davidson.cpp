// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/davidson.h"

#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/wilson.h"
#include "renderer/base/check.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

void check_tied(const char* where, const TiedVotes& votes, double confidence) {
    base::check_range(where, "count_a", votes.a, std::int64_t{0}, kMaxCount);
    base::check_range(where, "count_b", votes.b, std::int64_t{0}, kMaxCount);
    base::check_range(where, "count_none", votes.none, std::int64_t{0}, kMaxCount);
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input("{}: confidence is {}, allowed is between 0 and 1", where,
                              confidence);
    }
}

[[nodiscard]] double share_of(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

}  // namespace

Possible<DavidsonPair> davidson_pair(const TiedVotes& votes, double confidence) {
    check_tied("davidson_pair", votes, confidence);
    if (votes.a == 0 || votes.b == 0) {
        return Possible<DavidsonPair>::none(votes.a == 0 && votes.b == 0
                                                ? "nobody saw a difference"
                                                : "all who saw a difference chose the same image");
    }
    const auto a = static_cast<double>(votes.a);
    const auto b = static_cast<double>(votes.b);
    DavidsonPair fit;
    fit.log_odds = std::log(b / a);
    fit.standard_error = std::sqrt(1.0 / a + 1.0 / b);
    fit.nu = static_cast<double>(votes.none) / std::sqrt(a * b);
    fit.share_b = b / (a + b);
    const double reach = fit.standard_error * boost::math::quantile(boost::math::complement(
                                                  boost::math::normal(), (1.0 - confidence) / 2.0));
    fit.interval = {share_of(fit.log_odds - reach), share_of(fit.log_odds + reach)};
    // Answers without a difference have the same likelihood under both and cancel.
    const double mean = 0.5 * (a + b);
    fit.likelihood_ratio = std::max(0.0, 2.0 * (a * std::log(a / mean) + b * std::log(b / mean)));
    fit.p = chi_square_tail(fit.likelihood_ratio, 1);
    return fit;
}

Possible<SplitShare> split_share(const TiedVotes& votes, double confidence) {
    check_tied("split_share", votes, confidence);
    const Possible<PValue> p = exact_binomial(votes.b, votes.a + votes.b);
    if (!p.has_value()) return Possible<SplitShare>::none("nobody saw a difference");
    SplitShare split;
    split.p = *p;
    split.share_b = (static_cast<double>(votes.b) + 0.5 * static_cast<double>(votes.none)) /
                    static_cast<double>(votes.n());
    split.interval = *wilson_of_share(split.share_b, votes.n(), confidence);
    return split;
}

}  // namespace obscura::analysis
