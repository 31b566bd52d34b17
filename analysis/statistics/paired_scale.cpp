// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/paired_scale.h"

#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Log probability and its slope for a difference, and Fisher's information of one vote.
struct LinkPoint {
    double log_share = 0.0;    ///< of choosing `one`
    double log_other = 0.0;    ///< of choosing `other`
    double slope_share = 0.0;  ///< derivatives of the two
    double slope_other = 0.0;
    double information = 0.0;
};

LinkPoint logistic_point(double x) {
    const double share = 1.0 / (1.0 + std::exp(-x));
    const double other = 1.0 / (1.0 + std::exp(x));
    const double log_share = x > 0.0 ? -std::log1p(std::exp(-x)) : x - std::log1p(std::exp(x));
    return {log_share, log_share - x, other, -share, share * other};
}

LinkPoint jod_point(double difference) {
    static const double unit = boost::math::quantile(boost::math::normal(), 0.75);
    const double x = difference * unit;
    const double share = std::erfc(-x / std::numbers::sqrt2) / 2.0;
    const double other = std::erfc(x / std::numbers::sqrt2) / 2.0;
    const double density = std::exp(-x * x / 2.0) / std::sqrt(2.0 * std::numbers::pi) * unit;
    return {std::log(share), std::log(other), density / share, -density / other,
            density / share * (density / other)};
}

/// What is fitted: one value for each thing but the reference, and the order term last.
class Model {
  public:
    Model(std::size_t things, const std::vector<PairVotes>& pairs, const ScaleOptions& options)
        : pairs_(pairs), options_(options), things_(things) {
        if (options.prior_sd <= 0.0) return;
        std::set<std::pair<std::size_t, std::size_t>> known;
        for (const PairVotes& pair : pairs) {
            restrained_.push_back(known.insert(std::minmax(pair.one, pair.other)).second);
        }
    }

    [[nodiscard]] std::size_t size() const { return things_ - 1 + (options_.order_term ? 1 : 0); }

    /// The place of a thing's value; size() for the reference, which has none.
    [[nodiscard]] std::size_t place(std::size_t thing) const {
        if (thing == options_.reference) return size();
        return thing < options_.reference ? thing : thing - 1;
    }

    /// Of the votes, and of the prior where there is one, without constants.
    [[nodiscard]] double log_posterior(const VectorXd& at) const {
        double sum = log_likelihood(at);
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            if (!is_restrained(i)) continue;
            const double difference = value(pairs_[i].one, at) - value(pairs_[i].other, at);
            sum -= difference * difference * prior_precision() / 2.0;
        }
        if (options_.order_term && options_.prior_sd > 0.0) {
            sum -= at(size() - 1) * at(size() - 1) * prior_precision() / 2.0;
        }
        return sum;
    }

    [[nodiscard]] double log_likelihood(const VectorXd& at) const {
        double sum = 0.0;
        for (const PairVotes& pair : pairs_) {
            const LinkPoint point = point_of(pair, at);
            if (pair.one_chosen > 0) sum += point.log_share * count(pair.one_chosen);
            if (pair.other_chosen > 0) sum += point.log_other * count(pair.other_chosen);
        }
        return sum;
    }

    /// Adds what one vote of the pair adds to the gradient, and says to which of its places.
    void add_vote(const PairVote& vote, const VectorXd& at, VectorXd& gradient,
                  std::vector<std::size_t>& touched) const {
        const PairVotes& pair = pairs_[vote.pair];
        const LinkPoint point = point_of(pair, at);
        const double slope = vote.one_chosen ? point.slope_share : point.slope_other;
        for (const auto& [row, factor] : terms_of(pair)) {
            if (row == size()) continue;
            gradient(row) += factor * slope;
            touched.push_back(row);
        }
    }

    void derivatives(const VectorXd& at, VectorXd& gradient, MatrixXd& information) const {
        const auto n = static_cast<Eigen::Index>(size());
        gradient = VectorXd::Zero(n);
        information = MatrixXd::Zero(n, n);
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            const PairVotes& pair = pairs_[i];
            const LinkPoint point = point_of(pair, at);
            double slope = 0.0;
            if (pair.one_chosen > 0) slope += point.slope_share * count(pair.one_chosen);
            if (pair.other_chosen > 0) slope += point.slope_other * count(pair.other_chosen);
            const double weight = point.information * count(pair.one_chosen + pair.other_chosen);
            add(terms_of(pair), slope, weight, gradient, information);
            if (!is_restrained(i)) continue;
            const double difference = value(pair.one, at) - value(pair.other, at);
            const Terms two{std::pair{place(pair.one), 1.0}, std::pair{place(pair.other), -1.0},
                            std::pair{size(), 0.0}};
            add(two, -difference * prior_precision(), prior_precision(), gradient, information);
        }
        if (options_.order_term && options_.prior_sd > 0.0) {
            gradient(n - 1) -= at(n - 1) * prior_precision();
            information(n - 1, n - 1) += prior_precision();
        }
    }

  private:
    static double count(std::int64_t votes) { return static_cast<double>(votes); }

    /// What a pair's difference is made of: the place of each value with its factor; size() where
    /// there is none.
    using Terms = std::array<std::pair<std::size_t, double>, 3>;

    [[nodiscard]] Terms terms_of(const PairVotes& pair) const {
        return {std::pair{place(pair.one), 1.0}, std::pair{place(pair.other), -1.0},
                std::pair{options_.order_term ? size() - 1 : size(),
                          static_cast<double>(pair.order_side)}};
    }

    void add(const Terms& terms, double slope, double weight, VectorXd& gradient,
             MatrixXd& information) const {
        for (const auto& [row, factor] : terms) {
            if (row == size()) continue;
            gradient(row) += factor * slope;
            for (const auto& [column, other_factor] : terms) {
                if (column != size()) information(row, column) += factor * other_factor * weight;
            }
        }
    }

    [[nodiscard]] double prior_precision() const {
        return 1.0 / (options_.prior_sd * options_.prior_sd);
    }

    /// Whether the prior holds the pair's difference: each two things once, in whichever order of
    /// showing they come.
    [[nodiscard]] bool is_restrained(std::size_t pair) const {
        return !restrained_.empty() && restrained_[pair];
    }

    [[nodiscard]] double value(std::size_t thing, const VectorXd& at) const {
        return thing == options_.reference ? 0.0 : at(place(thing));
    }

    [[nodiscard]] LinkPoint point_of(const PairVotes& pair, const VectorXd& at) const {
        double difference = value(pair.one, at) - value(pair.other, at);
        if (options_.order_term) difference += at(size() - 1) * pair.order_side;
        return options_.link == ScaleLink::kLogistic ? logistic_point(difference)
                                                     : jod_point(difference);
    }

    const std::vector<PairVotes>& pairs_;
    const ScaleOptions& options_;
    std::size_t things_;
    std::vector<bool> restrained_;  ///< empty without a prior
};

/// The inverse of a symmetric positive definite matrix; false when it is singular.
bool invert(const MatrixXd& matrix, MatrixXd& inverse) {
    const Eigen::LLT<MatrixXd> factors(matrix);
    if (factors.info() != Eigen::Success) return false;
    inverse = factors.solve(MatrixXd::Identity(matrix.rows(), matrix.cols()));
    return inverse.allFinite();
}

/// Things that can be reached from the first by going from one to those it was chosen over, or
/// backwards.
std::vector<bool> reached(std::size_t count, const std::vector<PairVotes>& pairs, bool backwards) {
    std::vector<std::vector<std::size_t>> over(count);
    for (const PairVotes& pair : pairs) {
        const auto add = [&](std::size_t chosen, std::size_t left) {
            over[backwards ? left : chosen].push_back(backwards ? chosen : left);
        };
        if (pair.one_chosen > 0) add(pair.one, pair.other);
        if (pair.other_chosen > 0) add(pair.other, pair.one);
    }
    std::vector<bool> met(count);
    std::vector<std::size_t> next{0};
    met[0] = true;
    while (!next.empty()) {
        const std::size_t from = next.back();
        next.pop_back();
        for (const std::size_t to : over[from]) {
            if (!met[to]) next.push_back(to);
            met[to] = true;
        }
    }
    return met;
}

std::string names_where(const std::vector<std::string>& things, const std::vector<bool>& which,
                        bool wanted) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < things.size(); ++i) {
        if (which[i] == wanted) names.push_back(things[i]);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Why there is no finite scale; empty where there is one.
std::string obstacle(const std::vector<std::string>& things, const std::vector<PairVotes>& pairs,
                     const ScaleOptions& options) {
    const auto groups = connected_groups(things.size(), pairs);
    if (groups.size() > 1) {
        std::vector<std::string> names;
        for (const auto& group : groups) {
            std::vector<std::string> members;
            for (const std::size_t thing : group) members.push_back(things[thing]);
            names.push_back(fmt::format("({})", fmt::join(members, ", ")));
        }
        return fmt::format("no pair connects {}", fmt::join(names, " with "));
    }
    if (options.prior_sd > 0.0) return "";
    const std::vector<bool> below = reached(things.size(), pairs, false);
    if (std::count(below.begin(), below.end(), false) > 0) {
        return fmt::format("the votes are separated: ({}) was always chosen over ({})",
                           names_where(things, below, false), names_where(things, below, true));
    }
    const std::vector<bool> above = reached(things.size(), pairs, true);
    if (std::count(above.begin(), above.end(), false) > 0) {
        return fmt::format("the votes are separated: ({}) was always chosen over ({})",
                           names_where(things, above, true), names_where(things, above, false));
    }
    return "";
}

void check_pairs(std::size_t count, const std::vector<PairVotes>& pairs,
                 const ScaleOptions& options) {
    base::check_range("fit_scale", "number of things", count, std::size_t{1}, kMaxScaled);
    base::check_range("fit_scale", "reference", options.reference, std::size_t{0}, count - 1);
    for (const PairVotes& pair : pairs) {
        base::check_range("fit_scale", "one", pair.one, std::size_t{0}, count - 1);
        base::check_range("fit_scale", "other", pair.other, std::size_t{0}, count - 1);
        base::check_range("fit_scale", "one_chosen", pair.one_chosen, std::int64_t{0}, kMaxCount);
        base::check_range("fit_scale", "other_chosen", pair.other_chosen, std::int64_t{0},
                          kMaxCount);
        base::check_range("fit_scale", "order_side", pair.order_side, -1, 1);
        if (pair.one == pair.other) {
            throw base::bad_input("fit_scale: a pair is of thing {} with itself, allowed are two",
                                  pair.one);
        }
    }
}

Scale scale_at(const Model& model, const VectorXd& at, const MatrixXd& covariance,
               std::size_t things, const ScaleOptions& options) {
    Scale scale;
    scale.log_likelihood = model.log_likelihood(at);
    for (std::size_t thing = 0; thing < things; ++thing) {
        const std::size_t place = model.place(thing);
        const bool is_reference = thing == options.reference;
        scale.values.push_back(is_reference ? 0.0 : at(place));
        scale.standard_errors.push_back(is_reference ? 0.0 : std::sqrt(covariance(place, place)));
    }
    if (options.order_term) {
        const std::size_t last = model.size() - 1;
        scale.order_term = at(last);
        scale.order_standard_error = std::sqrt(covariance(last, last));
    }
    return scale;
}

}  // namespace

std::vector<std::vector<std::size_t>> connected_groups(std::size_t count,
                                                       const std::vector<PairVotes>& pairs) {
    std::vector<std::size_t> parent(count);
    for (std::size_t i = 0; i < count; ++i) parent[i] = i;
    const auto root = [&](std::size_t thing) {
        while (parent[thing] != thing) thing = parent[thing] = parent[parent[thing]];
        return thing;
    };
    for (const PairVotes& pair : pairs) {
        if (pair.one_chosen + pair.other_chosen == 0) continue;
        const auto [low, high] = std::minmax({root(pair.one), root(pair.other)});
        parent[high] = low;
    }
    std::vector<std::vector<std::size_t>> by_root(count);
    for (std::size_t i = 0; i < count; ++i) by_root[root(i)].push_back(i);
    std::erase_if(by_root, [](const auto& group) { return group.empty(); });
    return by_root;
}

Possible<Scale> fit_scale(const std::vector<std::string>& things,
                          const std::vector<PairVotes>& pairs, const ScaleOptions& options) {
    check_pairs(things.size(), pairs, options);
    if (things.size() < 2) return Possible<Scale>::none("fewer than two to compare");
    if (const std::string why = obstacle(things, pairs, options); !why.empty()) {
        return Possible<Scale>::none(why);
    }
    const Model model(things.size(), pairs, options);
    VectorXd at = VectorXd::Zero(static_cast<Eigen::Index>(model.size()));
    VectorXd gradient;
    MatrixXd information;
    MatrixXd covariance;
    double likelihood = model.log_posterior(at);
    constexpr int kMostSteps = 500;
    constexpr double kSmallStep = 1e-10;
    for (int i = 0; i < kMostSteps; ++i) {
        model.derivatives(at, gradient, information);
        if (!invert(information, covariance)) break;
        const VectorXd step = covariance * gradient;
        if (step.lpNorm<Eigen::Infinity>() < kSmallStep) {
            return scale_at(model, at, covariance, things.size(), options);
        }
        // The likelihood is concave: halving the step always finds a better point.
        double part = 1.0;
        VectorXd tried = at + step;
        double better = model.log_posterior(tried);
        const double slack = 1e-12 * std::abs(likelihood);
        while (!(better >= likelihood - slack) && part > 1e-9) {
            part /= 2.0;
            tried = at + part * step;
            better = model.log_posterior(tried);
        }
        at = tried;
        likelihood = better;
    }
    return Possible<Scale>::none("the votes do not settle a finite scale");
}

Possible<Scale> with_participants_errors(const Scale& scale, const std::vector<PairVotes>& pairs,
                                         const ScaleOptions& options, const VotesOfEach& each) {
    using None = Possible<Scale>;
    const std::size_t things = scale.values.size();
    check_pairs(things, pairs, options);
    const Model model(things, pairs, options);
    const auto size = static_cast<Eigen::Index>(model.size());
    VectorXd at(size);
    for (std::size_t thing = 0; thing < things; ++thing) {
        if (thing != options.reference) at(model.place(thing)) = scale.values[thing];
    }
    if (options.order_term) at(size - 1) = scale.order_term;
    VectorXd gradient;
    MatrixXd information;
    MatrixXd inverse;
    model.derivatives(at, gradient, information);
    if (!invert(information, inverse)) return None::none("the votes do not settle a finite scale");
    MatrixXd between = MatrixXd::Zero(size, size);
    double participants = 0.0;
    std::vector<std::size_t> touched;
    gradient.setZero();
    for (std::size_t who = 0; who + 1 < each.begin.size(); ++who) {
        if (each.begin[who] == each.begin[who + 1]) continue;
        participants += 1.0;
        touched.clear();
        for (std::size_t i = each.begin[who]; i < each.begin[who + 1]; ++i) {
            base::check_range("with_participants_errors", "pair", each.votes[i].pair,
                              std::size_t{0}, pairs.size() - 1);
            model.add_vote(each.votes[i], at, gradient, touched);
        }
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        for (const std::size_t row : touched) {
            for (const std::size_t column : touched) {
                between(row, column) += gradient(row) * gradient(column);
            }
        }
        for (const std::size_t row : touched) gradient(row) = 0.0;
    }
    if (participants < 2.0) return None::none("fewer than two participants");
    const MatrixXd covariance = participants / (participants - 1.0) * inverse * between * inverse;
    return scale_at(model, at, covariance, things, options);
}

}  // namespace obscura::analysis
