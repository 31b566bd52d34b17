// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/sign_flip.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "analysis/statistics/chi_square.h"
#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

/// The most additions of an exact test.
constexpr double kMostSums = 2e7;

/// P(|sum of +-sizes| >= |sum|) by convolution: after each size, chance[s] is that of the sum
/// s - total.
double exact_p(const std::vector<std::int64_t>& sizes, std::int64_t total, std::int64_t sum) {
    std::vector<double> chance(static_cast<std::size_t>(2 * total + 1));
    std::vector<double> next(chance.size());
    const auto at = [&](std::int64_t value) { return static_cast<std::size_t>(value + total); };
    chance[at(0)] = 1.0;
    std::int64_t reach = 0;
    for (const std::int64_t size : sizes) {
        std::fill(next.begin(), next.end(), 0.0);
        for (std::int64_t value = -reach; value <= reach; ++value) {
            const double half = chance[at(value)] / 2.0;
            next[at(value + size)] += half;
            next[at(value - size)] += half;
        }
        chance.swap(next);
        reach += size;
    }
    double tail = 0.0;
    for (std::int64_t value = total; value >= std::abs(sum); --value) tail += chance[at(value)];
    return sum == 0 ? 1.0 : std::min(1.0, 2.0 * tail);
}

}  // namespace

Possible<SignFlipTest> sign_flip(const std::vector<std::int64_t>& differences) {
    constexpr std::int64_t kMost = 1'000'000;
    SignFlipTest test;
    std::vector<std::int64_t> sizes;
    std::int64_t total = 0;
    double squares = 0.0;
    for (const std::int64_t difference : differences) {
        base::check_range("sign_flip", "difference", difference, -kMost, kMost);
        if (difference == 0) continue;
        sizes.push_back(std::abs(difference));
        test.sum += difference;
        total += sizes.back();
        squares += static_cast<double>(difference) * static_cast<double>(difference);
    }
    test.participants = static_cast<std::int64_t>(sizes.size());
    if (sizes.empty()) {
        return Possible<SignFlipTest>::none("no participant chose one side more often");
    }
    test.is_exact = sizes.size() <= kMostFlipped &&
                    static_cast<double>(sizes.size()) * static_cast<double>(total) <= kMostSums;
    if (test.is_exact) {
        const double p = exact_p(sizes, total, test.sum);
        test.p = {p, std::log10(p)};
    } else {
        const auto sum = static_cast<double>(test.sum);
        test.p = chi_square_tail(sum * sum / squares, 1);
    }
    return test;
}

Possible<SignFlipTest> sign_flip_nearly(const std::vector<double>& differences) {
    SignFlipTest test;
    test.is_exact = false;
    double sum = 0.0;
    double squares = 0.0;
    for (const double difference : differences) {
        if (!std::isfinite(difference)) {
            throw base::bad_input(
                "sign_flip_nearly: a difference is {}, allowed is a finite number", difference);
        }
        if (difference != 0.0) ++test.participants;
        sum += difference;
        squares += difference * difference;
    }
    if (test.participants == 0) {
        return Possible<SignFlipTest>::none("no participant chose one side more often");
    }
    test.sum = std::llround(sum);
    test.p = chi_square_tail(sum * sum / squares, 1);
    return test;
}

}  // namespace obscura::analysis
