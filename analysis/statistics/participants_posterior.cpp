// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/participants_posterior.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "analysis/statistics/check_votes.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

/// log of x (x + 1) ... (x + n - 1).
double log_rising(double x, std::int64_t n) {
    return n == 0 ? 0.0 : std::lgamma(x + static_cast<double>(n)) - std::lgamma(x);
}

/// The probability of everybody's votes where each has a share of his own.
class Likelihood {
  public:
    explicit Likelihood(const std::vector<Votes>& each) {
        std::map<std::pair<std::int64_t, std::int64_t>, double> alike;
        for (const Votes& votes : each) {
            check_votes("participants_posterior", votes);
            if (votes.n() > 0) alike[{votes.b, votes.a}] += 1.0;
        }
        std::int64_t most = 0;
        for (const auto& [votes, participants] : alike) {
            alike_.push_back({votes.first, votes.second, participants});
            participants_ += participants;
            most = std::max(most, votes.first + votes.second);
            share_ += participants * static_cast<double>(votes.first) /
                      static_cast<double>(votes.first + votes.second);
        }
        if (participants_ > 0.0) share_ /= participants_;
        if (most <= kMostListed) list_factors(static_cast<std::size_t>(most));
    }
    [[nodiscard]] std::size_t different() const { return alike_.size(); }
    [[nodiscard]] double participants() const { return participants_; }
    [[nodiscard]] double mean_share() const { return share_; }
    [[nodiscard]] bool is_one_vote_each() const {
        return std::all_of(alike_.begin(), alike_.end(),
                           [](const Alike& alike) { return alike.b + alike.a == 1; });
    }

    /// A correlation of one participant's votes, more than 0 and less than 1, as the sum of the two
    /// parameters of the beta distribution of shares; what the logarithm has of it alone.
    struct Spread {
        double size = 0.0;
        double log_all = 0.0;
    };
    [[nodiscard]] Spread spread(double correlation) const {
        Spread spread{(1.0 - correlation) / correlation};
        for (std::size_t i = 0; i < factors_.size(); ++i) {
            spread.log_all += factors_[i].all * std::log(spread.size + static_cast<double>(i));
        }
        if (!factors_.empty()) return spread;
        for (const Alike& alike : alike_) {
            spread.log_all += alike.participants * log_rising(spread.size, alike.b + alike.a);
        }
        return spread;
    }
    [[nodiscard]] double log(double share, const Spread& spread) const {
        const double for_b = share * spread.size;
        const double for_a = (1.0 - share) * spread.size;
        double sum = -spread.log_all;
        for (std::size_t i = 0; i < factors_.size(); ++i) {
            const auto& [b, a, all] = factors_[i];
            if (b > 0.0) sum += b * std::log(for_b + static_cast<double>(i));
            if (a > 0.0) sum += a * std::log(for_a + static_cast<double>(i));
        }
        if (!factors_.empty()) return sum;
        for (const Alike& alike : alike_) {
            sum += alike.participants * (log_rising(for_b, alike.b) + log_rising(for_a, alike.a));
        }
        return sum;
    }

  private:
    /// Votes of a participant beyond which rising products are taken whole and not by their
    /// factors.
    static constexpr std::int64_t kMostListed = 63;

    void list_factors(std::size_t most) {
        factors_.resize(most);
        for (const Alike& alike : alike_) {
            const auto b = static_cast<std::size_t>(alike.b);
            const auto a = static_cast<std::size_t>(alike.a);
            for (std::size_t i = 0; i < b; ++i) factors_[i].b += alike.participants;
            for (std::size_t i = 0; i < a; ++i) factors_[i].a += alike.participants;
            for (std::size_t i = 0; i < b + a; ++i) factors_[i].all += alike.participants;
        }
    }

    /// Participants who gave as many votes for B and for A, together.
    struct Alike {
        std::int64_t b, a;
        double participants;
    };
    /// Participants with more than so many votes, for B, for A and together: how often the factor
    /// of that place is there.
    struct Factor {
        double b = 0.0, a = 0.0, all = 0.0;
    };
    std::vector<Alike> alike_;
    std::vector<Factor> factors_;  ///< empty where somebody gave more than kMostListed
    double participants_ = 0.0;
    double share_ = 0.0;
};

/// Points and weights of Gauss and Legendre's rule between two ends.
struct Rule {
    std::vector<double> points, weights;

    Rule(double low, double high) {
        using Gauss = boost::math::quadrature::gauss<double, 30>;
        const double half = (high - low) / 2.0;
        for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
            for (const double side : {-1.0, 1.0}) {
                points.push_back(low + half + side * half * Gauss::abscissa()[i]);
                weights.push_back(half * Gauss::weights()[i]);
            }
        }
    }
};

/// The correlations that are not out of the question.
Interval likely_correlations(const Likelihood& likelihood) {
    constexpr int kSteps = 200;
    constexpr double kFarBelow = 25.0;
    const double share = std::clamp(likelihood.mean_share(), .01, .99);
    std::vector<double> logs;
    for (int i = 0; i < kSteps; ++i) {
        logs.push_back(likelihood.log(share, likelihood.spread((i + .5) / kSteps)));
    }
    const double highest = *std::max_element(logs.begin(), logs.end());
    Interval likely{1.0, 0.0};
    for (int i = 0; i < kSteps; ++i) {
        if (logs[static_cast<std::size_t>(i)] < highest - kFarBelow) continue;
        likely.low = std::min(likely.low, std::max(0.0, (i - 1.0) / kSteps));
        likely.high = std::max(likely.high, std::min(1.0, (i + 2.0) / kSteps));
    }
    return likely;
}

/// The density of the share at equal steps, up to a factor.
struct Density {
    Interval range;
    std::vector<double> values;

    [[nodiscard]] double at(std::size_t step) const {
        // The ends are met exactly: a share above 1 by a rounding has no likelihood.
        return std::lerp(range.low, range.high,
                         static_cast<double>(step) / static_cast<double>(values.size() - 1));
    }
};

Density density_of(const Likelihood& likelihood) {
    constexpr std::size_t kSteps = 400;
    constexpr double kReach = 10.0;
    const double reach = kReach * .5 / std::sqrt(likelihood.participants());
    Density density;
    density.range = {std::max(0.0, likelihood.mean_share() - reach),
                     std::min(1.0, likelihood.mean_share() + reach)};
    density.values.resize(kSteps + 1);
    const Interval likely = likely_correlations(likelihood);
    const Rule rule(likely.low, likely.high);
    std::vector<Likelihood::Spread> spreads;
    for (const double correlation : rule.points) spreads.push_back(likelihood.spread(correlation));
    std::vector<double> logs(rule.points.size() * density.values.size(),
                             -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < density.values.size(); ++i) {
        const double share = density.at(i);
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            logs[i * rule.points.size() + k] = likelihood.log(share, spreads[k]);
        }
    }
    const double highest = *std::max_element(logs.begin(), logs.end());
    for (std::size_t i = 0; i < density.values.size(); ++i) {
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            density.values[i] +=
                rule.weights[k] * std::exp(logs[i * rule.points.size() + k] - highest);
        }
    }
    return density;
}

/// The share of the density below each step.
std::vector<double> below(const Density& density) {
    std::vector<double> sums{0.0};
    for (std::size_t i = 1; i < density.values.size(); ++i) {
        sums.push_back(sums.back() + (density.values[i - 1] + density.values[i]) / 2.0);
    }
    for (double& sum : sums) sum /= sums.back();
    return sums;
}

double quantile(const Density& density, const std::vector<double>& below, double part) {
    const auto above = std::upper_bound(below.begin(), below.end() - 1, part);
    const auto step = static_cast<std::size_t>(above - below.begin());
    const double along = (part - below[step - 1]) / (below[step] - below[step - 1]);
    return density.at(step - 1) + along * (density.at(step) - density.at(step - 1));
}

double part_below(const Density& density, const std::vector<double>& below, double share) {
    if (share <= density.range.low) return 0.0;
    if (share >= density.range.high) return 1.0;
    const double place = (share - density.range.low) / (density.range.high - density.range.low) *
                         static_cast<double>(below.size() - 1);
    const auto step = std::min(static_cast<std::size_t>(place), below.size() - 2);
    return below[step] + (place - static_cast<double>(step)) * (below[step + 1] - below[step]);
}

}  // namespace

Possible<Posterior> participants_posterior(const std::vector<Votes>& each, double confidence) {
    using None = Possible<Posterior>;
    const Likelihood likelihood(each);
    if (likelihood.is_one_vote_each()) {
        Votes sum;
        for (const Votes& votes : each) sum = {sum.a + votes.a, sum.b + votes.b};
        return posterior_flat(sum.b, sum.n(), confidence);
    }
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input(
            "participants_posterior: confidence is {}, allowed is more than 0 and less than 1",
            confidence);
    }
    if (likelihood.different() > kMostVotedAlike) {
        return None::none("too many participants with different numbers of votes");
    }
    const Density density = density_of(likelihood);
    const std::vector<double> sums = below(density);
    Posterior posterior;
    double total = 0.0;
    double mean = 0.0;
    for (std::size_t i = 0; i < density.values.size(); ++i) {
        total += density.values[i];
        mean += density.values[i] * density.at(i);
    }
    if (!(total > 0.0)) return None::none("the density of the share could not be computed");
    posterior.mean = mean / total;
    const double tail = (1.0 - confidence) / 2.0;
    posterior.interval = {quantile(density, sums, tail), quantile(density, sums, 1.0 - tail)};
    posterior.above_half.p = 1.0 - part_below(density, sums, .5);
    posterior.above_half.log10_p = std::log10(posterior.above_half.p);
    return posterior;
}

}  // namespace obscura::analysis
