// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/chi_square.h"
#include "analysis/statistics/possible.h"
#include "analysis/statistics/quartiles.h"

namespace obscura::analysis {

/// One condition: by how much its two images differ, and the votes it got.
struct PreferencePoint {
    std::string condition;
    std::string validity;     ///< low, moderate or high; may be empty
    double difference = 0.0;  ///< what is measured of B minus that of A (an error, or milliseconds)
    Votes votes;
};

/// How the choice follows the difference: logit P(B is chosen) = slope * difference. There is no
/// constant term: which of two images is called A says nothing, and two that do not differ are
/// chosen alike. A negative slope over differences of error says that the more accurate image is
/// preferred.
struct PreferenceFit {
    double slope = 0.0;              ///< log odds for each unit of difference
    double standard_error = 0.0;     ///< of the slope, from the curvature of the likelihood
    Interval slope_interval;         ///< 95 %, by profile likelihood
    ChiSquareTest likelihood_ratio;  ///< against slope 0, df 1
    /// Deviance from the votes themselves, df points - 1: a small p says that the votes do not
    /// follow the curve. No value for one point.
    Possible<ChiSquareTest> lack_of_fit = Possible<ChiSquareTest>::none("only one point");
    /// The difference B - A at which 75 % choose B, ln 3 / slope. Negative over errors: B is that
    /// much more accurate. No value for slope 0.
    Possible<double> difference_75 = Possible<double>::none("the slope is 0");
    /// 95 %, from the ends of the slope's interval; no value where that holds 0, because then the
    /// votes allow that no difference at all is enough.
    Possible<Interval> difference_75_interval = Possible<Interval>::none("not known");
    std::int64_t votes = 0;
    std::size_t points = 0;  ///< with votes

    /// The share that chooses B at a difference, 0 to 1.
    [[nodiscard]] double share_b(double difference) const;
};

struct PreferenceCurve {
    Possible<PreferenceFit> overall = Possible<PreferenceFit>::none("no votes");
    /// Each level of validity that a point names, low before moderate before high before others.
    std::vector<std::pair<std::string, Possible<PreferenceFit>>> by_validity;
};

/// Logistic regression through the origin by maximum likelihood (D. R. Cox 1958), the interval by
/// profile likelihood (D. J. Venzon and S. H. Moolgavkar 1988), taking the votes as independent.
/// No fit, with the reason: without votes; when all differences are 0; when they are all of one
/// size, so that no dependence on it can show; when the votes are separated, every one of them for
/// the side with the smaller (or the larger) value, so that no finite slope is likeliest. Throws
/// bad input for a difference that is not finite and counts outside 0 to kMaxCount.
[[nodiscard]] PreferenceCurve preference_curve(const std::vector<PreferencePoint>& points);

}  // namespace obscura::analysis
