// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/clustered_share.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "analysis/statistics/check_votes.h"
#include "renderer/base/error.h"

namespace obscura::analysis {

Possible<Interval> clustered_share(const std::vector<Votes>& each, double confidence) {
    using None = Possible<Interval>;
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw base::bad_input("clustered_share: confidence is {}, allowed is between 0 and 1",
                              confidence);
    }
    Votes sum;
    double participants = 0.0;
    for (const Votes& votes : each) {
        check_votes("clustered_share", votes);
        if (votes.n() > 0) participants += 1.0;
        sum.a += votes.a;
        sum.b += votes.b;
    }
    if (participants < 2.0) return None::none("fewer than two participants");
    const auto n = static_cast<double>(sum.n());
    const double share = static_cast<double>(sum.b) / n;
    double squares = 0.0;
    for (const Votes& votes : each) {
        // In whole numbers first, so that nobody's difference from the others is exactly 0.
        const double off = (static_cast<double>(votes.b) * static_cast<double>(sum.a) -
                            static_cast<double>(votes.a) * static_cast<double>(sum.b)) /
                           n;
        squares += off * off;
    }
    if (squares == 0.0) return None::none("no participant differs from the others");
    const double error = std::sqrt(participants / (participants - 1.0) * squares) / n;
    const boost::math::students_t t(participants - 1.0);
    const double reach =
        error * boost::math::quantile(boost::math::complement(t, (1.0 - confidence) / 2.0));
    return Interval{std::max(0.0, share - reach), std::min(1.0, share + reach)};
}

}  // namespace obscura::analysis
