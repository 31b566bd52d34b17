// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/alpha_spending.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

constexpr double kLargestZ = 38.0;  // beyond, a double holds no tail

double tail(double z) { return std::erfc(z / std::numbers::sqrt2) / 2.0; }
double below(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2.0; }

double z_of_tail(double p) {
    if (p <= tail(kLargestZ)) return kLargestZ;
    return boost::math::quantile(boost::math::complement(boost::math::normal(), p));
}

double spent_at(Spending spending, double level, double share) {
    if (share >= 1.0) return level;
    switch (spending) {
        case Spending::kNone:
            return 0.0;
        case Spending::kObrienFleming:
            return 4.0 * tail(z_of_tail(level / 4.0) / std::sqrt(share));
        case Spending::kPocock:
            return level * std::log1p((std::numbers::e - 1.0) * share);
    }
    return 0.0;
}

/// A Brownian motion of which only the paths are left that no look has ended.
class Paths {
  public:
    /// How many of all paths a look at `time` ends that stops beyond |z|.
    [[nodiscard]] double ended(double z, double time) const {
        const double reach = z * std::sqrt(time);
        if (at_.empty()) return 2.0 * tail(z);
        const double spread = std::sqrt(time - time_);
        double sum = 0.0;
        for (std::size_t i = 0; i < at_.size(); ++i) {
            sum += mass_[i] * (tail((reach - at_[i]) / spread) + below((-reach - at_[i]) / spread));
        }
        return sum;
    }

    /// Goes on to `time` with those within |z|.
    void go_on(double z, double time) {
        const double reach = z * std::sqrt(time);
        const double spread = std::sqrt(time - time_);
        std::vector<double> at(kPoints);
        std::vector<double> mass(kPoints);
        const double step = 2.0 * reach / (kPoints - 1);
        for (std::size_t i = 0; i < kPoints; ++i) {
            at[i] = -reach + step * static_cast<double>(i);
            const double simpson = i == 0 || i == kPoints - 1 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
            mass[i] = simpson * step / 3.0 * density(at[i], spread);
        }
        at_ = std::move(at);
        mass_ = std::move(mass);
        time_ = time;
    }

  private:
    static constexpr std::size_t kPoints = 801;

    [[nodiscard]] double density(double place, double spread) const {
        const auto normal = [&](double from) {
            const double z = (place - from) / spread;
            return std::exp(-z * z / 2.0) / (spread * std::sqrt(2.0 * std::numbers::pi));
        };
        if (at_.empty()) return normal(0.0);
        double sum = 0.0;
        for (std::size_t i = 0; i < at_.size(); ++i) sum += mass_[i] * normal(at_[i]);
        return sum;
    }

    double time_ = 0.0;
    std::vector<double> at_;
    std::vector<double> mass_;
};

double time_of(const std::vector<std::int64_t>& looks, std::size_t look) {
    return static_cast<double>(looks[look]) / static_cast<double>(looks.back());
}

/// The z that ends just so many of the paths.
double z_ending(const Paths& paths, double time, double share) {
    if (share <= 0.0) return kLargestZ;
    double low = 0.0;
    double high = kLargestZ;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2.0;
        (paths.ended(middle, time) > share ? low : high) = middle;
    }
    return high;
}

void check_looks(const std::vector<std::int64_t>& looks) {
    base::check_range("look boundaries", "number of looks", looks.size(), std::size_t{1},
                      kMostLooks);
    base::check_range("look boundaries", "first look", looks.front(), std::int64_t{1}, INT64_MAX);
    for (std::size_t i = 1; i < looks.size(); ++i) {
        base::check_range("look boundaries", "next look", looks[i], looks[i - 1] + 1, INT64_MAX);
    }
}

}  // namespace

std::string_view to_string(Spending spending) {
    switch (spending) {
        case Spending::kNone:
            return "none";
        case Spending::kObrienFleming:
            return "obrien-fleming";
        case Spending::kPocock:
            return "pocock";
    }
    return "";
}

std::optional<Spending> spending_from(std::string_view name) {
    for (const Spending spending : kSpendings) {
        if (to_string(spending) == name) return spending;
    }
    return std::nullopt;
}

std::vector<LookBoundary> look_boundaries(Spending spending, double level,
                                          const std::vector<std::int64_t>& looks,
                                          std::int64_t planned) {
    check_looks(looks);
    std::vector<LookBoundary> boundaries;
    Paths paths;
    double before = 0.0;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const double share = static_cast<double>(looks[i]) / static_cast<double>(planned);
        LookBoundary& look = boundaries.emplace_back();
        look.spent = spent_at(spending, level, share);
        look.z = z_ending(paths, time_of(looks, i), look.spent - before);
        look.p = 2.0 * tail(look.z);
        if (i + 1 < looks.size()) paths.go_on(look.z, time_of(looks, i));
        before = look.spent;
    }
    return boundaries;
}

double p_after_spending(double p, Spending spending, const std::vector<std::int64_t>& looks,
                        std::int64_t planned) {
    if (!(p > 0.0) || p >= 1.0) return std::clamp(p, 0.0, 1.0);
    const auto counts = [&](double level) {
        return look_boundaries(spending, level, looks, planned).back().p >= p;
    };
    double low = std::log(p);
    double high = 0.0;  // level 1
    if (!counts(std::exp(-1e-9))) return 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2.0;
        (counts(std::min(std::exp(middle), 1.0 - 1e-12)) ? high : low) = middle;
    }
    return std::exp(high);
}

double repeated_look_error(double level, const std::vector<std::int64_t>& looks) {
    check_looks(looks);
    const double z = z_of_tail(level / 2.0);
    Paths paths;
    double error = 0.0;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        error += paths.ended(z, time_of(looks, i));
        if (i + 1 < looks.size()) paths.go_on(z, time_of(looks, i));
    }
    return error;
}

}  // namespace obscura::analysis
