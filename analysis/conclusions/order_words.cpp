// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/order_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/conclusions/words.h"
#include "analysis/statistics/sign_flip.h"
#include "renderer/base/random.h"

namespace obscura::analysis {
namespace {

double log_odds(double share) { return std::log(share / (1.0 - share)); }

/// By G. E. P. Box and M. E. Muller 1958.
double draw_liking(base::Random& random) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform(0.0, 1.0)));
    return radius * std::cos(2.0 * std::numbers::pi * random.uniform(0.0, 1.0));
}

/// How often the test by flipping signs finds that B is preferred.
double power_of_sides(const SideCost& cost, bool is_varied) {
    base::Random random(kAnalysisSeed);
    const double pull = log_odds(cost.second);
    int found = 0;
    std::vector<std::int64_t> differences(static_cast<std::size_t>(cost.participants));
    for (int study = 0; study < kSideStudies; ++study) {
        for (std::size_t who = 0; who < differences.size(); ++who) {
            const double liking = log_odds(kRelevantShare) + draw_liking(random);
            differences[who] = 0;
            for (std::size_t i = 0; i < cost.conditions; ++i) {
                const bool b_second = (is_varied ? who + i : who) % 2 == 0;
                const double odds = liking + (b_second ? pull : -pull);
                const bool chose_b = random.uniform(0.0, 1.0) < 1.0 / (1.0 + std::exp(-odds));
                differences[who] += chose_b ? 1 : -1;
            }
        }
        const auto test = sign_flip(differences);
        if (test.has_value() && test->p.p < kSignificance && test->sum > 0) ++found;
    }
    return static_cast<double>(found) / kSideStudies;
}

/// The strongest liking for a place that the interval leaves possible.
double strongest_pull(const OrderByParticipant& order) {
    double difference = order.difference;
    if (order.interval.has_value()) {
        difference = std::abs(order.interval->low) > std::abs(order.interval->high)
                         ? order.interval->low
                         : order.interval->high;
    }
    return std::clamp(.5 + difference / 2.0, .01, .99);
}

std::string cost_words(const Analysis& analysis) {
    const OrderByParticipant& order = *analysis.order_bias->by_participant;
    std::size_t conditions = 1;
    for (const HypothesisResult& result : analysis.hypotheses) {
        if (result.pooling.has_value()) conditions = std::max(conditions, result.conditions.size());
    }
    constexpr std::size_t kMostCostedConditions = 100;
    if (order.participants > kMostCosted || conditions > kMostCostedConditions) {
        return "One side for all pairs of a session costs power where a place is liked, since that "
               "liking then moves all votes of a participant the same way.";
    }
    const SideCost cost = side_cost(order.participants, conditions, strongest_pull(order));
    return fmt::format(
        "One side for all pairs of a session costs power where a place is liked, since that liking "
        "then moves all votes of a participant the same way: where the second of two alike images "
        "is chosen in {:.0f} %, the strongest liking that these answers leave possible, a study of "
        "{} and {} finds a true share of {:g} % in {:.0f} % of the cases, and in {:.0f} % where "
        "the sides change within a session (sides = \"trial\" in the study file; {} simulated "
        "studies each, standard deviation of the observers 1 in log odds, seed {}, p below {:g} "
        "taken alone).",
        100.0 * cost.second, counted(cost.participants, "participant"),
        counted(static_cast<std::int64_t>(cost.conditions), "pooled condition"),
        100.0 * kRelevantShare, 100.0 * cost.constant, 100.0 * cost.varied, kSideStudies,
        kAnalysisSeed, kSignificance);
}

}  // namespace

SideCost side_cost(std::int64_t participants, std::size_t conditions, double second) {
    SideCost cost{participants, conditions, second};
    cost.constant = power_of_sides(cost, false);
    cost.varied = power_of_sides(cost, true);
    return cost;
}

std::string order_words(const Analysis& analysis) {
    const Possible<OrderByParticipant>& order = analysis.order_bias->by_participant;
    if (!order.has_value()) {
        return fmt::format("Over participants the order is not tested: {}.", order.reason);
    }
    std::string text = fmt::format(
        "Over {}{}, {}: the image shown second is chosen by {:+.1f} points more often than the "
        "first",
        counted(order->participants, "participant"),
        order->left_out > 0 ? fmt::format(" ({} who answered fewer left out)", order->left_out)
                            : "",
        order->kind == OrderTestKind::kSideGroups
            ? "of whom each saw the same variant first in every pair"
            : "who saw either variant first in some pairs",
        100.0 * order->difference);
    if (order->interval.has_value()) {
        text += fmt::format(" (95 % interval {:+.1f} to {:+.1f})", 100.0 * order->interval->low,
                            100.0 * order->interval->high);
    }
    text +=
        fmt::format(", {} {}, {}.", order->is_exact ? "exact" : "large-sample",
                    order->kind == OrderTestKind::kSideGroups ? "permutation between the two groups"
                                                              : "test by flipping signs",
                    p_words(order->p));
    if (order->kind != OrderTestKind::kSideGroups) return text;
    return text + ' ' + cost_words(analysis);
}

}  // namespace obscura::analysis
