// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/order.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "analysis/statistics/group_permutation.h"
#include "analysis/statistics/mean_test.h"
#include "analysis/statistics/sign_flip.h"

namespace obscura::analysis {
namespace {

using Order = Possible<OrderByParticipant>;

/// What the order says of one participant.
struct OwnOrder {
    std::int64_t votes = 0;
    std::int64_t b_second = 0;  ///< of them, those in which B was shown second
    std::int64_t chose_b = 0;
    std::int64_t chose_second = 0;

    [[nodiscard]] bool has_one_side() const { return b_second == 0 || b_second == votes; }
};

/// Those who answered most conditions, and how many answered fewer.
std::vector<OwnOrder> complete(const VotesByParticipant& votes, std::int64_t& left_out) {
    std::vector<OwnOrder> all;
    std::int64_t most = 0;
    for (std::size_t participant = 0; participant < votes.participants(); ++participant) {
        OwnOrder own;
        for (const auto& vote : votes.of(participant)) {
            const Answer& answer = votes.answer(vote);
            ++own.votes;
            if (answer.b_second) ++own.b_second;
            if (answer.chose_b) ++own.chose_b;
            if (answer.chose_b == answer.b_second) ++own.chose_second;
        }
        if (own.votes > 0) all.push_back(own);
        most = std::max(most, own.votes);
    }
    const auto before = static_cast<std::int64_t>(all.size());
    std::erase_if(all, [&](const OwnOrder& own) { return own.votes < most; });
    left_out = before - static_cast<std::int64_t>(all.size());
    return all;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Of the difference of two means (B. L. Welch 1947).
Possible<Interval> welch(const std::vector<double>& one, const std::vector<double>& other) {
    const auto variance = [](const std::vector<double>& values) {
        const double mean = mean_of(values);
        double squares = 0.0;
        for (const double value : values) squares += (value - mean) * (value - mean);
        const auto n = static_cast<double>(values.size());
        return squares / (n - 1.0) / n;
    };
    if (one.size() < 2 || other.size() < 2) {
        return Possible<Interval>::none("fewer than two participants in a group");
    }
    const double first = variance(one);
    const double second = variance(other);
    if (first + second <= 0.0) return Possible<Interval>::none("nobody varies within the groups");
    const double df = (first + second) * (first + second) /
                      (first * first / (static_cast<double>(one.size()) - 1.0) +
                       second * second / (static_cast<double>(other.size()) - 1.0));
    const double reach =
        std::sqrt(first + second) * boost::math::quantile(boost::math::complement(
                                        boost::math::students_t(df), (1.0 - kConfidence) / 2.0));
    const double difference = mean_of(one) - mean_of(other);
    return Interval{std::max(-1.0, difference - reach), std::min(1.0, difference + reach)};
}

Order by_side_groups(const std::vector<OwnOrder>& participants, OrderByParticipant result) {
    std::vector<std::int64_t> counts[2];
    std::vector<double> shares[2];  // of B; with B second and with B first
    for (const OwnOrder& own : participants) {
        const int group = own.b_second > 0 ? 0 : 1;
        counts[group].push_back(own.chose_b);
        shares[group].push_back(static_cast<double>(own.chose_b) / static_cast<double>(own.votes));
    }
    const auto test = group_permutation(counts[0], counts[1]);
    if (!test.has_value()) {
        return Order::none(counts[0].empty() || counts[1].empty()
                               ? "everybody saw the same variant first"
                               : test.reason);
    }
    result.kind = OrderTestKind::kSideGroups;
    result.p = test->p;
    result.is_exact = test->is_exact;
    result.difference = mean_of(shares[0]) - mean_of(shares[1]);
    result.interval = welch(shares[0], shares[1]);
    return result;
}

Order by_sign_flip(const std::vector<OwnOrder>& participants, OrderByParticipant result) {
    std::vector<std::int64_t> differences;
    std::vector<double> means;
    for (const OwnOrder& own : participants) {
        differences.push_back(2 * own.chose_second - own.votes);
        means.push_back(static_cast<double>(differences.back()) / static_cast<double>(own.votes));
    }
    const auto test = sign_flip(differences);
    if (!test.has_value()) return Order::none("everybody chose both places equally often");
    result.kind = OrderTestKind::kSignFlip;
    result.p = test->p;
    result.is_exact = test->is_exact;
    result.difference = mean_of(means);
    if (const auto mean = mean_test(means, kConfidence); mean.has_value()) {
        result.interval =
            Interval{std::max(-1.0, mean->interval.low), std::min(1.0, mean->interval.high)};
    } else {
        result.interval = Possible<Interval>::none(mean.reason);
    }
    return result;
}

}  // namespace

Possible<OrderByParticipant> order_by_participant(const VotesByParticipant& votes) {
    OrderByParticipant result;
    const std::vector<OwnOrder> participants = complete(votes, result.left_out);
    result.participants = static_cast<std::int64_t>(participants.size());
    if (participants.empty()) return Order::none("no votes");
    const bool is_constant = std::all_of(participants.begin(), participants.end(),
                                         [](const OwnOrder& own) { return own.has_one_side(); });
    return is_constant ? by_side_groups(participants, result) : by_sign_flip(participants, result);
}

}  // namespace obscura::analysis
