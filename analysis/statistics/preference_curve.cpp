// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/preference_curve.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "analysis/statistics/check_votes.h"
#include "analysis/statistics/logistic.h"

namespace obscura::analysis {
namespace {

/// Votes at one difference, which is measured in units of the largest.
struct Point {
    double x = 0.0;  ///< -1 to 1
    double a = 0.0;
    double b = 0.0;
};
using Points = std::vector<Point>;

double log_likelihood(const Points& points, double slope) {
    double sum = 0.0;
    for (const Point& point : points) {
        const double logit = slope * point.x;
        sum -= point.b * log1p_exp(-logit) + point.a * log1p_exp(logit);
    }
    return sum;
}

struct Derivatives {
    double gradient = 0.0;
    double information = 0.0;
};

Derivatives derivatives(const Points& points, double slope) {
    Derivatives at;
    for (const Point& point : points) {
        const double share = logistic(slope * point.x);
        const double other = logistic(-slope * point.x);
        at.gradient += point.x * (point.b * other - point.a * share);
        at.information += point.x * point.x * (point.a + point.b) * share * other;
    }
    return at;
}

/// Where a function that grows from below 0 is 0, to the last digits.
template <typename Function>
double root_of(const Function& function, double low, double high) {
    std::uintmax_t most_steps = 200;
    const auto [left, right] = boost::math::tools::toms748_solve(
        function, low, high, boost::math::tools::eps_tolerance<double>(50), most_steps);
    return (left + right) / 2.0;
}

/// The likeliest slope. The gradient falls with it and changes sign, as the votes are not
/// separated.
double likeliest_slope(const Points& points) {
    const auto gradient = [&](double slope) { return derivatives(points, slope).gradient; };
    const double at_zero = gradient(0.0);
    if (at_zero == 0.0) return 0.0;
    double end = at_zero > 0.0 ? 1.0 : -1.0;
    while ((gradient(end) > 0.0) == (at_zero > 0.0)) end *= 2.0;
    return root_of(gradient, std::min(0.0, end), std::max(0.0, end));
}

/// Where the likelihood has fallen by half the chi-square quantile, on the side of `step`.
double profile_bound(const Points& points, double slope, double step) {
    static const double fall =
        boost::math::quantile(boost::math::chi_squared(1), 0.95) / 2.0;  // kConfidence
    const double top = log_likelihood(points, slope);
    const auto above = [&](double at) { return log_likelihood(points, at) - top + fall; };
    double end = slope + step;
    while (above(end) > 0.0) {
        step *= 2.0;
        end = slope + step;
    }
    return root_of(above, std::min(slope, end), std::max(slope, end));
}

ChiSquareTest deviance_test(double deviance, int df) {
    const double statistic = std::max(0.0, deviance);
    return {statistic, df, chi_square_tail(statistic, df)};
}

/// Log likelihood of each point's own share.
double saturated(const Points& points) {
    double sum = 0.0;
    for (const Point& point : points) {
        const double n = point.a + point.b;
        if (point.a > 0.0) sum += point.a * std::log(point.a / n);
        if (point.b > 0.0) sum += point.b * std::log(point.b / n);
    }
    return sum;
}

/// Why there is no finite slope, or nothing to see it by; empty where there is one.
std::string obstacle(const Points& points) {
    if (points.empty()) return "no votes";
    const double largest = std::abs(points.front().x);
    bool alike = true;
    double agreeing = 0.0;
    double opposing = 0.0;
    for (const Point& point : points) {
        alike &= std::abs(point.x) == largest;
        if (point.x == 0.0) continue;
        agreeing += point.x > 0.0 ? point.b : point.a;
        opposing += point.x > 0.0 ? point.a : point.b;
    }
    if (agreeing + opposing == 0.0) return "the images of no pair with votes differ";
    if (alike) {
        return points.size() == 1
                   ? "only one pair has votes, so that no dependence on the difference can show"
                   : "all pairs differ by the same amount, so that no dependence on it can show";
    }
    if (agreeing == 0.0 || opposing == 0.0) {
        return fmt::format(
            "the votes are separated: every one is for the image with the {} value, so that no "
            "finite slope is likeliest",
            agreeing == 0.0 ? "smaller" : "larger");
    }
    return "";
}

/// `unit` is what x is measured in.
PreferenceFit fit_of(const Points& points, double unit) {
    const double slope = likeliest_slope(points);
    const double error = 1.0 / std::sqrt(derivatives(points, slope).information);
    const double top = log_likelihood(points, slope);
    PreferenceFit fit;
    fit.slope = slope / unit;
    fit.standard_error = error / unit;
    fit.slope_interval = {profile_bound(points, slope, -error) / unit,
                          profile_bound(points, slope, error) / unit};
    fit.likelihood_ratio = deviance_test(2.0 * (top - log_likelihood(points, 0.0)), 1);
    if (points.size() > 1) {
        fit.lack_of_fit =
            deviance_test(2.0 * (saturated(points) - top), static_cast<int>(points.size()) - 1);
    }
    constexpr double kLogOdds75 = 1.0986122886681098;  // ln 3: odds of 3 to 1
    const Interval& ends = fit.slope_interval;
    if (slope != 0.0) fit.difference_75 = kLogOdds75 / fit.slope;
    if (ends.low > 0.0 || ends.high < 0.0) {
        fit.difference_75_interval = Interval{kLogOdds75 / ends.high, kLogOdds75 / ends.low};
    } else {
        fit.difference_75_interval = Possible<Interval>::none(
            "the slope's interval holds 0: the votes allow that no difference is enough");
    }
    for (const Point& point : points) fit.votes += std::llround(point.a + point.b);
    fit.points = points.size();
    return fit;
}

Possible<PreferenceFit> fit_of(const std::vector<const PreferencePoint*>& chosen) {
    double unit = 0.0;
    for (const PreferencePoint* point : chosen) {
        if (point->votes.n() > 0) unit = std::max(unit, std::abs(point->difference));
    }
    Points points;
    for (const PreferencePoint* point : chosen) {
        if (point->votes.n() == 0) continue;
        points.push_back({unit > 0.0 ? point->difference / unit : 0.0,
                          static_cast<double>(point->votes.a),
                          static_cast<double>(point->votes.b)});
    }
    if (const std::string why = obstacle(points); !why.empty()) {
        return Possible<PreferenceFit>::none(why);
    }
    return fit_of(points, unit);
}

/// low, moderate, high, then the others by name.
std::pair<std::ptrdiff_t, std::string> level_order(const std::string& level) {
    constexpr std::array<std::string_view, 3> kLevels{"low", "moderate", "high"};
    const auto place = std::find(kLevels.begin(), kLevels.end(), level) - kLevels.begin();
    return {place, level};
}

}  // namespace

double PreferenceFit::share_b(double difference) const { return logistic(slope * difference); }

PreferenceCurve preference_curve(const std::vector<PreferencePoint>& points) {
    std::vector<const PreferencePoint*> all;
    std::map<std::pair<std::ptrdiff_t, std::string>, std::vector<const PreferencePoint*>> levels;
    for (const PreferencePoint& point : points) {
        check_votes("preference_curve", point.votes);
        if (!std::isfinite(point.difference)) {
            throw base::bad_input(
                "preference_curve: the difference of condition {} is {}, allowed is a finite "
                "number",
                point.condition, point.difference);
        }
        all.push_back(&point);
        if (!point.validity.empty()) levels[level_order(point.validity)].push_back(&point);
    }
    PreferenceCurve curve;
    curve.overall = fit_of(all);
    for (const auto& [level, chosen] : levels) {
        curve.by_validity.emplace_back(level.second, fit_of(chosen));
    }
    return curve;
}

}  // namespace obscura::analysis
