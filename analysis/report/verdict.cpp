// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/report/verdict.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>

#include "analysis/report/words.h"
#include "analysis/statistics/holm.h"
#include "analysis/statistics/power.h"
#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

/// A condition of a hypothesis with its corrected exact p-value.
struct Tested {
    const ConditionResult* result = nullptr;
    double p = 1.0;
};

std::vector<Tested> exact_with_holm(const Analysis& analysis) {
    std::vector<Tested> tested;
    std::vector<double> p_values;
    for (const ConditionResult& result : analysis.conditions) {
        if (!result.preference.exact.has_value()) continue;
        tested.push_back({&result, 1.0});
        p_values.push_back(result.preference.exact->p);
    }
    const std::vector<double> corrected = holm(p_values);
    for (std::size_t i = 0; i < tested.size(); ++i) tested[i].p = corrected[i];
    return tested;
}

VerdictKind kind_of(bool is_for, bool is_against, bool has_power) {
    if (is_for && is_against) return VerdictKind::kContradictory;
    if (is_for) return VerdictKind::kEvidenceFor;
    if (is_against) return VerdictKind::kEvidenceAgainst;
    return has_power ? VerdictKind::kNoEvidence : VerdictKind::kTooFew;
}

std::string votes_words(const HypothesisResult& result) {
    const Votes& votes = result.pooled.votes;
    return fmt::format("{} of {} answers ({}) were for B over {} ({})", votes.b, votes.n(),
                       percent(*result.pooled.share_b),
                       counted(static_cast<std::int64_t>(result.conditions.size()), "condition"),
                       listed(result.conditions));
}

std::string significant_words(const std::vector<Tested>& mine, std::size_t tests) {
    std::vector<std::string> names;
    for (const Tested& test : mine) {
        if (test.p < kSignificance) {
            const bool prefers_b = *test.result->preference.share_b > 0.5;
            names.push_back(fmt::format("{} ({} preferred, corrected {})",
                                        test.result->condition.id, prefers_b ? "B" : "A",
                                        p_words({test.p, 0.0})));
        }
    }
    if (!names.empty()) {
        return fmt::format("significant after correcting for {} tests: {}", tests, listed(names));
    }
    const auto smallest = std::min_element(
        mine.begin(), mine.end(), [](const Tested& a, const Tested& b) { return a.p < b.p; });
    return fmt::format(
        "none is significant after correcting for {} tests (smallest corrected {}, in {})", tests,
        p_words({smallest->p, 0.0}), smallest->result->condition.id);
}

Verdict preference_verdict(const HypothesisResult& result, const std::vector<Tested>& all) {
    Verdict verdict{result.name, VerdictKind::kNothingKnown,
                    "There are no answers, so nothing can be said."};
    std::vector<Tested> mine;
    for (const Tested& test : all) {
        if (test.result->condition.hypothesis == result.name) mine.push_back(test);
    }
    if (mine.empty()) return verdict;
    bool is_for = false;
    bool is_against = false;
    std::int64_t fewest = kMostParticipants;
    for (const Tested& test : mine) {
        const bool is_significant = test.p < kSignificance;
        is_for |= is_significant && *test.result->preference.share_b > 0.5;
        is_against |= is_significant && *test.result->preference.share_b < 0.5;
        fewest = std::min(fewest, test.result->condition.votes.n());
    }
    const double level = kSignificance / static_cast<double>(all.size());
    const double power = power_of(SplitTest::kExact, fewest, kShareToFind, level).power;
    verdict.kind = kind_of(is_for, is_against, power >= kPowerToHave);
    verdict.sentence = fmt::format(
        "{}; {}. With {} a condition, a true share of {} would come out significant in "
        "{} of such studies.",
        votes_words(result), significant_words(mine, all.size()), counted(fewest, "answer"),
        percent(kShareToFind), percent(power));
    return verdict;
}

/// The comparisons over levels that have a test, with Holm's correction over them.
Verdict validity_verdict(const ValidityResult& validity) {
    Verdict verdict{"H3", VerdictKind::kNothingKnown,
                    "No two variants were compared at more than one level of validity, so nothing "
                    "can be said."};
    std::vector<const Comparison*> tested;
    std::vector<double> p_values;
    for (const Comparison& comparison : validity.by_level) {
        const Possible<PValue> p = p_of(comparison);
        if (!p.has_value()) continue;
        tested.push_back(&comparison);
        p_values.push_back(p->p);
    }
    if (tested.empty()) return verdict;
    const std::vector<double> corrected = holm(p_values);
    bool is_for = false;
    std::int64_t fewest = kMostParticipants;
    std::string words;
    for (std::size_t i = 0; i < tested.size(); ++i) {
        is_for |= corrected[i] < kSignificance;
        std::vector<std::string> shares;
        for (std::size_t row = 0; row < tested[i]->votes.size(); ++row) {
            const Votes& votes = tested[i]->votes[row];
            if (votes.n() == 0) continue;
            fewest = std::min(fewest, votes.n());
            shares.push_back(
                fmt::format("{} at {} validity",
                            percent(static_cast<double>(votes.b) / static_cast<double>(votes.n())),
                            tested[i]->levels[row]));
        }
        words +=
            fmt::format("{} was chosen over {} by {} ({}{}); ", tested[i]->variant_b,
                        tested[i]->variant_a, listed(shares), p_words({p_values[i], 0.0}),
                        tested.size() == 1 ? "" : ", corrected " + p_words({corrected[i], 0.0}));
    }
    const double level = kSignificance / static_cast<double>(tested.size());
    const double power = power_of_difference(fewest, 0.5, kShareToFind, level);
    verdict.kind = kind_of(is_for, false, power >= kPowerToHave);
    verdict.sentence = fmt::format(
        "{}with {} a level, shares of 50 % and {} at two levels would be told apart in {} of such "
        "studies.",
        words, counted(fewest, "answer"), percent(kShareToFind), percent(power));
    return verdict;
}

}  // namespace

std::string to_words(VerdictKind kind) {
    switch (kind) {
        case VerdictKind::kEvidenceFor:
            return "evidence for";
        case VerdictKind::kEvidenceAgainst:
            return "evidence against";
        case VerdictKind::kContradictory:
            return "contradictory: evidence for and against";
        case VerdictKind::kNoEvidence:
            return "no evidence";
        case VerdictKind::kTooFew:
            return "too few participants to say";
        case VerdictKind::kNothingKnown:
            return "nothing known";
    }
    return "";
}

std::vector<Verdict> verdicts(const Analysis& analysis) {
    const std::vector<Tested> tested = exact_with_holm(analysis);
    std::vector<Verdict> all;
    bool has_h3 = false;
    for (const HypothesisResult& hypothesis : analysis.hypotheses) {
        all.push_back(preference_verdict(hypothesis, tested));
        has_h3 |= hypothesis.name == "H3";
    }
    if (!has_h3) all.push_back(validity_verdict(analysis.validity));
    return all;
}

std::vector<Possible<double>> exact_p_holm(const Analysis& analysis) {
    std::vector<Possible<double>> corrected;
    for (const ConditionResult& result : analysis.conditions) {
        corrected.push_back(Possible<double>::none(result.preference.exact.reason));
    }
    for (const Tested& test : exact_with_holm(analysis)) {
        corrected[static_cast<std::size_t>(test.result - analysis.conditions.data())] = test.p;
    }
    return corrected;
}

std::string verdict_rule() {
    return fmt::format(
        "The rule behind the verdicts, the same for every study: a condition counts when its exact "
        "binomial test, corrected by Holm's method over all conditions of the study, has p < "
        "{0:g}. "
        "“Evidence for” means that at least one condition of the hypothesis counts with B (the "
        "side that the hypothesis favours) preferred and none with A; “evidence against” the "
        "reverse. When none counts, it is “no evidence” if the study would have found a true share "
        "of {1} with at least {2} probability, and “too few participants to say” if not. For the "
        "influence of validity (H3) the tests are those of the difference between levels, on the "
        "same participants where their answers are known and from the counts otherwise, corrected "
        "over the pairs of variants compared; the power is that of telling 50 % from {1}.",
        kSignificance, percent(kShareToFind), percent(kPowerToHave));
}

double power_of_difference(std::int64_t n, double one, double other, double level) {
    constexpr const char* kWhere = "power_of_difference";
    base::check_range<std::int64_t>(kWhere, "n", n, 1, kMaxCount);
    for (const double share : {one, other, level}) {
        base::check_range(kWhere, "share or level", share, 1e-12, 1.0 - 1e-12);
    }
    const double mean = (one + other) / 2.0;
    const double noncentrality =
        static_cast<double>(n) * (one - other) * (one - other) / (2.0 * mean * (1.0 - mean));
    const boost::math::chi_squared_distribution<double> null(1.0);
    const double critical = boost::math::quantile(boost::math::complement(null, level));
    if (noncentrality == 0.0) return level;
    constexpr double kCertain = 1e4;  // the distribution's own series take long beyond
    if (noncentrality > kCertain) return 1.0;
    const boost::math::non_central_chi_squared_distribution<double> shifted(1.0, noncentrality);
    return boost::math::cdf(boost::math::complement(shifted, critical));
}

}  // namespace obscura::analysis
