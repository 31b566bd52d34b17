// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/order_bias.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/check_votes.h"
#include "analysis/statistics/stratified_logistic.h"

namespace obscura::analysis {
namespace {

bool says_something(const OrderStratum& condition) {
    const Votes& second = condition.b_second;
    const Votes& first = condition.b_first;
    return second.n() > 0 && first.n() > 0 && second.a + first.a > 0 && second.b + first.b > 0;
}

/// Whether an ever larger order term only makes the votes likelier: in every condition the term of
/// the condition can follow it.
bool is_separated(const std::vector<OrderStratum>& kept) {
    const bool upwards = std::all_of(kept.begin(), kept.end(), [](const OrderStratum& votes) {
        return votes.b_second.a == 0 || votes.b_first.b == 0;
    });
    const bool downwards = std::all_of(kept.begin(), kept.end(), [](const OrderStratum& votes) {
        return votes.b_second.b == 0 || votes.b_first.a == 0;
    });
    return upwards || downwards;
}

}  // namespace

Possible<OrderBiasTest> order_bias(const std::vector<OrderStratum>& conditions) {
    using None = Possible<OrderBiasTest>;
    std::vector<OrderStratum> kept;
    std::vector<LogisticStratum> strata;
    for (const OrderStratum& condition : conditions) {
        check_votes("order_bias", condition.b_second);
        check_votes("order_bias", condition.b_first);
        if (!says_something(condition)) continue;
        kept.push_back(condition);
        strata.push_back({{1.0, condition.b_second}, {-1.0, condition.b_first}});
    }
    if (kept.empty()) {
        return None::none("no condition was shown in both orders and chosen both ways");
    }
    if (is_separated(kept)) {
        return None::none("the votes are separated by the order, so that no finite effect fits");
    }
    const Possible<StratifiedSlope> fit = stratified_slope(strata);
    if (!fit.has_value()) return None::none("the fit of the order effect did not settle");
    OrderBiasTest test;
    test.order_term = fit->slope;
    test.standard_error = fit->standard_error;
    test.second_share = 1.0 / (1.0 + std::exp(-fit->slope));
    test.likelihood_ratio = fit->likelihood_ratio;
    test.conditions = fit->strata;
    return test;
}

}  // namespace obscura::analysis
