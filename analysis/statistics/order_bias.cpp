// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/order_bias.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/statistics/check_votes.h"

namespace obscura::analysis {
namespace {

/// The votes of one order within a condition.
struct Cell {
    double b = 0.0;
    double n = 0.0;
    double side = 1.0;  ///< what the order term is multiplied with
};

/// One condition with its own term.
struct Stratum {
    std::array<Cell, 2> cells;
    double term = 0.0;

    [[nodiscard]] double share() const {
        return (cells[0].b + cells[1].b) / (cells[0].n + cells[1].n);
    }
};

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// log(1 + e^x) without overflow.
double log1p_exp(double x) { return std::max(x, 0.0) + std::log1p(std::exp(-std::abs(x))); }

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

Stratum stratum_of(const OrderStratum& votes) {
    const auto cell = [](const Votes& of, double side) {
        return Cell{static_cast<double>(of.b), static_cast<double>(of.n()), side};
    };
    Stratum stratum{{cell(votes.b_second, 1.0), cell(votes.b_first, -1.0)}};
    stratum.term = std::log(stratum.share() / (1.0 - stratum.share()));
    return stratum;
}

/// Twice the log likelihood above that of the model without an order term.
double twice_log_ratio(const std::vector<Stratum>& strata, double order_term) {
    double sum = 0.0;
    for (const Stratum& stratum : strata) {
        const double none = std::log(stratum.share() / (1.0 - stratum.share()));
        for (const Cell& cell : stratum.cells) {
            const double x = stratum.term + order_term * cell.side;
            sum += cell.b * (x - none) - cell.n * (log1p_exp(x) - log1p_exp(none));
        }
    }
    return 2.0 * sum;
}

/// Newton's step of all terms; the conditions' own are eliminated (Schur complement).
struct Step {
    double order = 0.0;
    std::vector<double> terms;
    double information = 0.0;  ///< of the order term, the others profiled out
};

Step newton_step(const std::vector<Stratum>& strata, double order_term) {
    struct Sums {
        double gradient = 0.0, weight = 0.0, cross = 0.0;
    };
    std::vector<Sums> sums;
    Step step;
    double gradient = 0.0;
    for (const Stratum& stratum : strata) {
        Sums own;
        double order_weight = 0.0;
        double order_gradient = 0.0;
        for (const Cell& cell : stratum.cells) {
            const double p = logistic(stratum.term + order_term * cell.side);
            const double residual = cell.b - cell.n * p;
            const double weight = cell.n * p * logistic(-stratum.term - order_term * cell.side);
            own.gradient += residual;
            own.weight += weight;
            own.cross += weight * cell.side;
            order_gradient += residual * cell.side;
            order_weight += weight;
        }
        gradient += order_gradient - own.cross / own.weight * own.gradient;
        step.information += order_weight - own.cross * own.cross / own.weight;
        sums.push_back(own);
    }
    step.order = gradient / step.information;
    for (const Sums& own : sums) {
        step.terms.push_back((own.gradient - own.cross * step.order) / own.weight);
    }
    return step;
}

}  // namespace

Possible<OrderBiasTest> order_bias(const std::vector<OrderStratum>& conditions) {
    using None = Possible<OrderBiasTest>;
    std::vector<OrderStratum> kept;
    for (const OrderStratum& condition : conditions) {
        check_votes("order_bias", condition.b_second);
        check_votes("order_bias", condition.b_first);
        if (says_something(condition)) kept.push_back(condition);
    }
    if (kept.empty()) {
        return None::none("no condition was shown in both orders and chosen both ways");
    }
    if (is_separated(kept)) {
        return None::none("the votes are separated by the order, so that no finite effect fits");
    }
    std::vector<Stratum> strata;
    for (const OrderStratum& condition : kept) strata.push_back(stratum_of(condition));

    constexpr int kMostSteps = 200;
    constexpr double kSmallStep = 1e-10;
    constexpr double kFar = 4.0;
    // What the likelihood may seem to fall by rounding alone.
    double slack = 1e-9;
    for (const Stratum& stratum : strata) {
        slack += 1e-14 * (stratum.cells[0].n + stratum.cells[1].n);
    }
    double order_term = 0.0;
    double ratio = 0.0;
    for (int i = 0; i < kMostSteps; ++i) {
        const Step step = newton_step(strata, order_term);
        if (!std::isfinite(step.order)) break;
        // The likelihood is concave: halving the step always finds a better point.
        // No further than where logits change by kFar, beyond which the curve is another.
        double part = 1.0;
        for (const double term : step.terms) {
            part = std::min(part, kFar / (std::abs(term) + std::abs(step.order)));
        }
        std::vector<Stratum> tried = strata;
        double reached = 0.0;
        for (; part > 1e-12; part /= 2.0) {
            for (std::size_t k = 0; k < strata.size(); ++k) {
                tried[k].term = strata[k].term + part * step.terms[k];
            }
            reached = twice_log_ratio(tried, order_term + part * step.order);
            if (reached >= ratio - slack) break;
        }
        strata = tried;
        order_term += part * step.order;
        ratio = reached;
        if (std::abs(step.order) > kSmallStep) continue;
        OrderBiasTest test;
        test.order_term = order_term;
        test.standard_error = 1.0 / std::sqrt(newton_step(strata, order_term).information);
        test.second_share = logistic(order_term);
        test.likelihood_ratio.statistic = std::max(0.0, ratio);
        test.likelihood_ratio.p = chi_square_tail(test.likelihood_ratio.statistic, 1);
        test.conditions = static_cast<int>(kept.size());
        return test;
    }
    return None::none("the fit of the order effect did not settle");
}

}  // namespace obscura::analysis
