// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/power.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "analysis/statistics/binomial.h"
#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/exact_binomial.h"
#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

void check_open(const char* name, double value) {
    if (!(value > 0.0 && value < 1.0)) {
        throw base::bad_input("power: {} is {}, allowed is more than 0 and less than 1", name,
                              value);
    }
}

double p_value(SplitTest test, std::int64_t votes, std::int64_t n) {
    if (test == SplitTest::kExact) return exact_binomial(votes, n)->p;
    return chi_square_equal_split({n - votes, votes})->p.p;
}

/// The fewest votes for the favoured side with p < level; n + 1 when there are none. p falls as the
/// votes grow beyond one half.
std::int64_t critical_votes(SplitTest test, std::int64_t n, double level) {
    std::int64_t low = n / 2;
    std::int64_t high = n + 1;
    while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (p_value(test, middle, n) < level ? high : low) = middle;
    }
    return high;
}

/// The chance of `critical` votes or more for either side.
double chance(std::int64_t n, std::int64_t critical, double share) {
    const Binomial binomial(n, share);
    return binomial.upper(critical).first + binomial.lower(n - critical).first;
}

/// A number of participants that is too small for the power, and so are all below it: what the
/// normal approximation gives, less a margin of several teeth of the saw, whose height is about one
/// outcome's probability, 2 phi(z) / sqrt(n).
std::int64_t surely_too_few(double share, double level, double power) {
    const boost::math::normal normal;
    const double z = boost::math::quantile(boost::math::complement(normal, level / 2.0)) +
                     boost::math::quantile(normal, power);
    if (z <= 0.0) return 0;
    const double off = std::abs(share - 0.5);
    const double about = z * z * share * (1.0 - share) / (off * off);
    return std::max(std::int64_t{0},
                    static_cast<std::int64_t>(about - 10.0 * std::sqrt(about) - 50.0));
}

}  // namespace

TestPower power_of(SplitTest test, std::int64_t n, double share, double level) {
    base::check_range("power", "n", n, std::int64_t{1}, kMostParticipants);
    check_open("share", share);
    check_open("level", level);
    TestPower result;
    result.n = n;
    const std::int64_t critical = critical_votes(test, n, level);
    if (critical > n) {
        result.critical_votes = Possible<std::int64_t>::none(
            "no outcome of so few participants is significant at this level");
        return result;
    }
    result.critical_votes = critical;
    result.power = chance(n, critical, share);
    result.true_size = chance(n, critical, 0.5);
    return result;
}

Possible<double> detectable_share(SplitTest test, std::int64_t n, double level, double power) {
    base::check_range("power", "n", n, std::int64_t{1}, kMostParticipants);
    check_open("level", level);
    check_open("power", power);
    constexpr double kSure = 1.0 - 1e-9;
    const std::int64_t critical = critical_votes(test, n, level);
    if (critical > n || chance(n, critical, kSure) < power) {
        return Possible<double>::none("so few participants detect no share");
    }
    double low = 0.5;
    double high = kSure;
    while (high - low > 1e-7) {
        const double middle = (low + high) / 2.0;
        (chance(n, critical, middle) >= power ? high : low) = middle;
    }
    return high;
}

Possible<std::int64_t> participants_needed(SplitTest test, double share, double level,
                                           double power) {
    check_open("share", share);
    check_open("level", level);
    check_open("power", power);
    if (!(std::abs(share - 0.5) >= kSmallestEffect)) {
        throw base::bad_input("power: share is {}, allowed is at least {:g} away from .5", share,
                              kSmallestEffect);
    }
    std::int64_t first = surely_too_few(share, level, power) + 1;
    std::int64_t critical = critical_votes(test, first, level);
    for (std::int64_t n = first; n <= kMostParticipants; ++n) {
        // One participant more moves the critical number by nothing or one.
        while (critical <= n && p_value(test, critical, n) >= level) ++critical;
        if (critical > n || chance(n, critical, share) < power) {
            first = n + 1;
        } else if (n - first == kStaysForNext) {
            return first;
        }
    }
    return Possible<std::int64_t>::none("more participants than can be asked");
}

}  // namespace obscura::analysis
