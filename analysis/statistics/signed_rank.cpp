// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/signed_rank.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

/// Twice the rank of each, which is a whole number also where sizes are equal.
std::vector<std::size_t> double_ranks(const std::vector<double>& sizes) {
    std::vector<std::size_t> order(sizes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t one, std::size_t other) { return sizes[one] < sizes[other]; });
    std::vector<std::size_t> ranks(sizes.size());
    for (std::size_t from = 0; from < order.size();) {
        std::size_t to = from;
        while (to < order.size() && sizes[order[to]] == sizes[order[from]]) ++to;
        // Ranks from + 1 ... to, of which the mean is half the sum of the ends.
        for (std::size_t i = from; i < to; ++i) ranks[order[i]] = from + 1 + to;
        from = to;
    }
    return ranks;
}

/// The share of all signs with a sum of positive ranks of at most `sum`.
double lower_tail(const std::vector<std::size_t>& ranks, std::size_t sum) {
    std::size_t all = 0;
    for (const std::size_t rank : ranks) all += rank;
    std::vector<double> share(all + 1, 0.0);
    share[0] = 1.0;
    std::size_t reached = 0;
    for (const std::size_t rank : ranks) {
        reached += rank;
        for (std::size_t at = reached + 1; at-- > 0;) {
            share[at] = 0.5 * (share[at] + (at >= rank ? share[at - rank] : 0.0));
        }
    }
    double tail = 0.0;
    for (std::size_t at = 0; at <= sum; ++at) tail += share[at];
    return tail;
}

PValue of_two_sides(double p) {
    p = std::min(1.0, p);
    return {p, std::log10(p)};
}

PValue by_normal(const std::vector<std::size_t>& ranks, double positive) {
    double sum = 0.0;
    double squares = 0.0;
    for (const std::size_t rank : ranks) {
        const double whole = 0.5 * static_cast<double>(rank);
        sum += whole;
        squares += whole * whole;
    }
    const double off = std::max(0.0, std::abs(positive - 0.5 * sum) - 0.5);
    const double z = off / std::sqrt(0.25 * squares);
    return of_two_sides(2.0 * boost::math::cdf(boost::math::complement(boost::math::normal(), z)));
}

}  // namespace

Possible<SignedRankTest> signed_rank(const std::vector<double>& differences) {
    SignedRankTest test;
    std::vector<double> sizes;
    std::vector<bool> above;
    for (const double difference : differences) {
        if (!std::isfinite(difference)) {
            throw base::bad_input("signed_rank: difference {} is not allowed, it must be finite",
                                  difference);
        }
        if (difference == 0.0) continue;
        sizes.push_back(std::abs(difference));
        above.push_back(difference > 0.0);
    }
    test.n = static_cast<std::int64_t>(sizes.size());
    test.zeros = static_cast<std::int64_t>(differences.size()) - test.n;
    if (sizes.empty()) {
        return Possible<SignedRankTest>::none(differences.empty() ? "there are no differences"
                                                                  : "all differences are 0");
    }
    const std::vector<std::size_t> ranks = double_ranks(sizes);
    std::size_t positive = 0;
    std::size_t all = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (above[i]) positive += ranks[i];
        all += ranks[i];
    }
    test.positive = 0.5 * static_cast<double>(positive);
    test.is_exact = sizes.size() <= kMostRanked;
    test.p = test.is_exact
                 ? of_two_sides(2.0 * lower_tail(ranks, std::min(positive, all - positive)))
                 : by_normal(ranks, test.positive);
    return test;
}

}  // namespace obscura::analysis
