// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <map>
#include <string>

#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/level_contrast.h"
#include "analysis/conclusions/pooled_share.h"
#include "analysis/statistics/mean_test.h"
#include "tests/support/calibration.h"
#include "tests/support/mantel_haenszel.h"

namespace obscura::tests {

/// How often, of studies, something came out: by its name.
class Rates {
  public:
    void count(const std::string& name, bool happened) {
        Rate& rate = rates_[name];
        ++rate.n;
        if (happened) ++rate.met;
    }
    [[nodiscard]] double of(const std::string& name) const {
        const Rate& rate = rates_.at(name);
        return static_cast<double>(rate.met) / static_cast<double>(rate.n);
    }
    [[nodiscard]] bool has(const std::string& name) const { return rates_.contains(name); }

  private:
    struct Rate {
        std::int64_t met = 0, n = 0;
    };
    std::map<std::string, Rate> rates_;
};

inline bool holds(const analysis::Interval& interval, double value) {
    return interval.low <= value && value <= interval.high;
}

/// H3 over None against Blizzard24 at two levels of which one holds two conditions (II against V
/// and VII), by the tests of the calibration's first table.
inline void count_levels(const analysis::Tally& tally, Rates& rates) {
    using namespace analysis;
    ConditionVotes second = tally.conditions[6];
    second.view = tally.conditions[1].view;
    const std::vector<const ConditionVotes*> three{&tally.conditions[1], &tally.conditions[4],
                                                   &second};
    const auto contrast = level_contrast(three, "moderate");
    rates.count("sign flip of d", contrast->p.p < .05);
    rates.count("interval of d", holds(contrast->interval, 0.0));
    std::vector<double> d;
    std::vector<TwoByTwo> tables;
    for (std::size_t who = 0; who < tally.participants.size(); ++who) {
        const auto b = [&](std::size_t i) {
            return tally.conditions[i].answers[who].chose_b ? 1 : 0;
        };
        const int high = b(4) + b(6);
        d.push_back(high - 2.0 * b(1));
        tables.push_back({1.0 * b(1), 1.0 - b(1), 1.0 * high, 2.0 - high});
    }
    const auto t = mean_test(d);
    rates.count("t of d", t.has_value() && t->p.p < .05);
    rates.count("exact CMH by participant", mantel_haenszel(tables, true).p_exact < .05);
    const Votes& one = tally.conditions[1].votes;
    const Votes other{tally.conditions[4].votes.a + tally.conditions[6].votes.a,
                      tally.conditions[4].votes.b + tally.conditions[6].votes.b};
    const auto chi = chi_square_homogeneity({one, other});
    rates.count("counts as independent", chi.has_value() && chi->p.p < .05);
}

/// What is so over all people.
struct Truth {
    double share = .5;  ///< of B in H1's conditions, each variant as often first
    double jod = 0.0;   ///< of Blizzard24 over None
    double order =
        0.0;  ///< by how much more often B is chosen where it is second, in all conditions
};

inline Truth truth_of(const People& people) {
    constexpr std::array<std::size_t, 3> kFirst{1, 4, 6};  // II, V, VII
    Truth truth;
    truth.share = 0.0;
    for (const std::size_t i : kFirst) {
        for (const bool b_second : {false, true}) {
            truth.share += share_of_b(people, i, b_second) / 6.0;
        }
    }
    const boost::math::normal normal;
    truth.jod = boost::math::quantile(normal, truth.share) / boost::math::quantile(normal, .75);
    for (std::size_t i = 0; i < 7; ++i) {
        truth.order += (share_of_b(people, i, true) - share_of_b(people, i, false)) / 7.0;
    }
    return truth;
}

inline void count_hypothesis(const analysis::HypothesisResult& result, const std::string& name,
                             double share, Rates& rates) {
    using namespace analysis;
    rates.count(name + ", sign flip", p_of(result)->p < .05);
    rates.count(name + ", chi-square of votes", result.pooled.chi_square->p.p < .05);
    rates.count(name + ", interval", holds(result.interval->bounds, share));
    rates.count(name + ", credible interval", holds(result.posterior->interval, share));
    if (result.model.has_value()) {
        rates.count(name + ", mixed model", result.model->effect->p.p < .05);
    }
}

inline void count_scale(const analysis::VariantScale& scale, double jod, Rates& rates) {
    if (!scale.jod_intervals.has_value()) return;
    for (std::size_t k = 1; k < scale.variants.size(); ++k) {
        if (scale.variants[k] != "Blizzard24") continue;
        rates.count("JOD, interval", holds((*scale.jod_intervals)[k], jod));
        const double error = scale.thurstone->standard_errors[k];
        rates.count("JOD, 1.96 SE", std::abs(scale.thurstone->values[k] - jod) < 1.96 * error);
    }
}

/// What the whole analysis says of studies in which each of `people` answers.
inline void count_studies(const People& people, int participants, int studies, std::uint64_t seed,
                          bool model, Rates& rates) {
    using namespace analysis;
    const Truth truth = truth_of(people);
    base::Random random(seed);
    for (int i = 0; i < studies; ++i) {
        const Tally tally = study_of(people, participants, random);
        count_levels(tally, rates);
        const Analysis analysis = analyse(tally, {.model = model});
        const HypothesisResult& h1 = analysis.hypotheses.at(0);
        count_hypothesis(h1, "H1", truth.share, rates);
        rates.count("conditions differ, Q",
                    h1.heterogeneity.has_value() && h1.heterogeneity->test.p.p < .05);
        if (h1.model.has_value() && h1.model->conditions_differ.has_value()) {
            rates.count("conditions differ, mixed model", h1.model->conditions_differ->p.p < .05);
        }
        for (const Comparison& comparison : analysis.validity->by_level) {
            rates.count("H3, McNemar", p_of(comparison)->p < .05);
            rates.count("H3, interval", holds(comparison.differences.at(0).interval, 0.0));
            if (comparison.model.has_value()) {
                rates.count("H3, mixed model", comparison.model->effect->p.p < .05);
            }
        }
        bool any = false;
        for (const Verdict& verdict : analysis.verdicts) {
            any |= verdict.p_holm.has_value() && *verdict.p_holm < .05;
            const bool is_equal = verdict.conclusion == Conclusion::kEqual ||
                                  verdict.conclusion == Conclusion::kSame || verdict.is_small;
            if (verdict.hypothesis != "H2") {
                rates.count(verdict.hypothesis + ", within 15 points", is_equal);
            }
        }
        rates.count("any verdict of the family", any);
        const auto& order = analysis.order_bias->by_participant;
        rates.count("order", order.has_value() && order->p.p < .05);
        rates.count("order, counts", analysis.order_bias->exact->p < .05);
        if (order.has_value() && order->interval.has_value()) {
            rates.count("order, interval", holds(*order->interval, truth.order));
        }
        count_scale(analysis.scales.at(0), truth.jod, rates);
    }
}

}  // namespace obscura::tests
