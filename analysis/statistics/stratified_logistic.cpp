// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/stratified_logistic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/statistics/check_votes.h"
#include "analysis/statistics/logistic.h"

namespace obscura::analysis {
namespace {

struct Cell {
    double x = 0.0;  ///< in units of the largest
    double b = 0.0;
    double n = 0.0;
};

/// One condition with its own term.
struct Stratum {
    std::vector<Cell> cells;
    double none = 0.0;  ///< the term in the model without slope
    double term = 0.0;
};

/// Where the votes for each side lie; nothing was met while low is above high.
struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    [[nodiscard]] bool is_empty() const { return low > high; }
};

struct Spans {
    Span a, b;

    explicit Spans(const LogisticStratum& stratum) {
        for (const LogisticCell& cell : stratum) {
            if (cell.votes.a > 0) a.add(cell.x);
            if (cell.votes.b > 0) b.add(cell.x);
        }
    }
    [[nodiscard]] bool says_something() const {
        return !a.is_empty() && !b.is_empty() && std::min(a.low, b.low) < std::max(a.high, b.high);
    }
};

Stratum stratum_of(const LogisticStratum& votes, double unit) {
    Stratum stratum;
    double b = 0.0;
    double n = 0.0;
    for (const LogisticCell& cell : votes) {
        if (cell.votes.n() == 0) continue;
        stratum.cells.push_back({cell.x / unit, static_cast<double>(cell.votes.b),
                                 static_cast<double>(cell.votes.n())});
        b += stratum.cells.back().b;
        n += stratum.cells.back().n;
    }
    stratum.none = stratum.term = std::log(b / (n - b));
    return stratum;
}

/// Twice the log likelihood above that of the model without slope.
double twice_log_ratio(const std::vector<Stratum>& strata, double slope) {
    double sum = 0.0;
    for (const Stratum& stratum : strata) {
        for (const Cell& cell : stratum.cells) {
            const double logit = stratum.term + slope * cell.x;
            sum += cell.b * (logit - stratum.none) -
                   cell.n * (log1p_exp(logit) - log1p_exp(stratum.none));
        }
    }
    return 2.0 * sum;
}

/// Newton's step of all terms; the strata's own are eliminated (Schur complement).
struct Step {
    double slope = 0.0;
    std::vector<double> terms;
    double information = 0.0;  ///< of the slope, the others profiled out
};

Step newton_step(const std::vector<Stratum>& strata, double slope) {
    struct OfStratum {
        double gradient = 0.0, weight = 0.0, cross = 0.0;
    };
    std::vector<OfStratum> sums;
    sums.reserve(strata.size());
    Step step;
    double gradient = 0.0;
    for (const Stratum& stratum : strata) {
        OfStratum own;
        double slope_weight = 0.0;
        double slope_gradient = 0.0;
        for (const Cell& cell : stratum.cells) {
            const double logit = stratum.term + slope * cell.x;
            const double share = logistic(logit);
            const double residual = cell.b - cell.n * share;
            const double weight = cell.n * share * logistic(-logit);
            own.gradient += residual;
            own.weight += weight;
            own.cross += weight * cell.x;
            slope_gradient += residual * cell.x;
            slope_weight += weight * cell.x * cell.x;
        }
        gradient += slope_gradient - own.cross / own.weight * own.gradient;
        step.information += slope_weight - own.cross * own.cross / own.weight;
        sums.push_back(own);
    }
    step.slope = gradient / step.information;
    step.terms.reserve(strata.size());
    for (const OfStratum& own : sums) {
        step.terms.push_back((own.gradient - own.cross * step.slope) / own.weight);
    }
    return step;
}

/// Goes along a step as far as the likelihood grows, and no further than where logits change by
/// kFar, beyond which the curve is another. The likelihood is concave: halving the step always
/// finds a better point. Returns what was reached.
double go(std::vector<Stratum>& strata, double& slope, const Step& step, double ratio,
          double slack) {
    constexpr double kFar = 4.0;
    double part = 1.0;
    for (const double term : step.terms) {
        part = std::min(part, kFar / (std::abs(term) + std::abs(step.slope)));
    }
    std::vector<Stratum> tried = strata;
    double reached = 0.0;
    for (; part > 1e-12; part /= 2.0) {
        for (std::size_t k = 0; k < strata.size(); ++k) {
            tried[k].term = strata[k].term + part * step.terms[k];
        }
        reached = twice_log_ratio(tried, slope + part * step.slope);
        if (reached >= ratio - slack) break;
    }
    strata.swap(tried);
    slope += part * step.slope;
    return reached;
}

Possible<StratifiedSlope> fit(std::vector<Stratum> strata, double unit) {
    constexpr int kMostSteps = 200;
    constexpr double kSmallStep = 1e-10;
    double slack = 1e-9;  // what the likelihood may seem to fall by rounding alone
    for (const Stratum& stratum : strata) {
        for (const Cell& cell : stratum.cells) slack += 1e-14 * cell.n;
    }
    double slope = 0.0;
    double ratio = 0.0;
    for (int i = 0; i < kMostSteps; ++i) {
        const Step step = newton_step(strata, slope);
        if (!std::isfinite(step.slope)) break;
        ratio = go(strata, slope, step, ratio, slack);
        if (std::abs(step.slope) > kSmallStep) continue;
        StratifiedSlope result;
        result.slope = slope / unit;
        result.standard_error = 1.0 / std::sqrt(newton_step(strata, slope).information) / unit;
        result.likelihood_ratio.statistic = std::max(0.0, ratio);
        result.likelihood_ratio.p = chi_square_tail(result.likelihood_ratio.statistic, 1);
        result.strata = static_cast<int>(strata.size());
        return result;
    }
    return Possible<StratifiedSlope>::none("the fit did not settle");
}

}  // namespace

Possible<StratifiedSlope> stratified_slope(const std::vector<LogisticStratum>& strata) {
    using None = Possible<StratifiedSlope>;
    double unit = 0.0;
    bool upwards = true;  // an ever larger slope only makes the votes likelier
    bool downwards = true;
    std::vector<const LogisticStratum*> kept;
    for (const LogisticStratum& stratum : strata) {
        for (const LogisticCell& cell : stratum) {
            check_votes("stratified_slope", cell.votes);
            if (!std::isfinite(cell.x)) {
                throw base::bad_input("stratified_slope: x is {}, allowed is a finite number",
                                      cell.x);
            }
        }
        const Spans spans(stratum);
        if (!spans.says_something()) continue;
        kept.push_back(&stratum);
        upwards &= spans.a.high <= spans.b.low;
        downwards &= spans.b.high <= spans.a.low;
        for (const LogisticCell& cell : stratum) unit = std::max(unit, std::abs(cell.x));
    }
    if (kept.empty()) {
        return None::none("no condition was shown at two values and chosen both ways");
    }
    if (upwards || downwards) {
        return None::none("the votes are separated, so that no finite slope fits");
    }
    std::vector<Stratum> scaled;
    scaled.reserve(kept.size());
    for (const LogisticStratum* stratum : kept) scaled.push_back(stratum_of(*stratum, unit));
    return fit(std::move(scaled), unit);
}

}  // namespace obscura::analysis
