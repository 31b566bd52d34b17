// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/hypotheses.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/conclusions/pooling.h"
#include "analysis/conclusions/words.h"
#include "analysis/statistics/clopper_pearson.h"
#include "analysis/statistics/cohens_g.h"
#include "analysis/statistics/exact_binomial.h"

namespace obscura::analysis {
namespace {

/// What is not pooled has no numbers, and says why.
Preference nothing_pooled(const std::string& why) {
    Preference preference;
    preference.share_b = Possible<double>::none(why);
    preference.chi_square = Possible<ChiSquareTest>::none(why);
    preference.exact = Possible<PValue>::none(why);
    preference.wilson = Possible<Interval>::none(why);
    preference.clopper_pearson = Possible<Interval>::none(why);
    preference.cohens_g = Possible<double>::none(why);
    preference.posterior = Possible<Posterior>::none(why);
    preference.bayes_factor = Possible<BayesFactor>::none(why);
    return preference;
}

std::string alone_words(const HypothesisResult& result, std::size_t tests) {
    return fmt::format(
        "Alone {} of its {} {} significant at {:g}, after Holm's correction for {} {}.{}",
        result.significant,
        counted(static_cast<std::int64_t>(result.conditions.size()), "condition"),
        result.significant == 1 ? "is" : "are", kSignificance,
        counted(static_cast<std::int64_t>(tests), "test"), result.significant_holm,
        result.secondary.empty()
            ? ""
            : fmt::format(" {} {} secondary and no part of it.", listed(result.secondary),
                          result.secondary.size() == 1 ? "is" : "are"));
}

std::string sentence_of(const HypothesisResult& result, std::size_t tests) {
    if (!result.pooling.has_value()) {
        return fmt::format("{} ({}): {}. {}", result.name, fmt::join(result.conditions, ", "),
                           result.pooling.reason, alone_words(result, tests));
    }
    const Possible<ChiSquareTest>& test = result.pooled.chi_square;
    if (!test.has_value()) {
        return fmt::format("{}: no votes, so nothing can be said.", result.name);
    }
    const Votes& votes = result.pooled.votes;
    return fmt::format(
        "{} ({}): together {} for A and {} for B ({:.1f} % B), chi-square {:.4g}, df {}, {} "
        "where all votes are taken as independent. {}. {}",
        result.name, fmt::join(result.conditions, ", "), counted(votes.a, "vote"), votes.b,
        100.0 * *result.pooled.share_b, test->statistic, test->df, p_words(test->p),
        capital(result.pooling->words), alone_words(result, tests));
}

/// Votes that count as B and as A where the condition may be turned.
Votes turned(const Votes& votes, bool is_turned) {
    return is_turned ? Votes{votes.b, votes.a} : votes;
}

HypothesisResult tested(const PlannedHypothesis& planned, const std::vector<ConditionResult>& all) {
    HypothesisResult result;
    result.name = planned.id;
    result.statement = planned.statement;
    result.margin = planned.margin;
    result.is_primary = planned.is_primary;
    result.unanswered = planned.conditions;
    std::vector<const ConditionVotes*> conditions;
    for (const ConditionResult& condition : all) {
        const std::string& id = condition.condition.id;
        if (std::erase(result.unanswered, id) == 0) {
            if (condition.condition.hypothesis == planned.id) result.secondary.push_back(id);
            continue;
        }
        conditions.push_back(&condition.condition);
        result.conditions.push_back(id);
        if (is_significant(condition.preference.exact)) ++result.significant;
        if (condition.p_holm.has_value() && *condition.p_holm < kSignificance) {
            ++result.significant_holm;
        }
    }
    if (!conditions.empty()) result.pooling = pooling_of(conditions);
    if (result.pooling.has_value()) {
        Votes sum;
        for (std::size_t i = 0; i < conditions.size(); ++i) {
            const Votes votes = turned(conditions[i]->votes, result.pooling->turned[i]);
            sum.a += votes.a;
            sum.b += votes.b;
        }
        result.pooled = preference_of(sum);
    } else {
        result.pooled = nothing_pooled(result.pooling.reason);
        result.each_once = Possible<PValue>::none(result.pooling.reason);
        result.posterior = Possible<Posterior>::none(result.pooling.reason);
        result.heterogeneity = Possible<Heterogeneity>::none(result.pooling.reason);
        result.by_participant = Possible<SignFlipTest>::none(result.pooling.reason);
        result.interval = Possible<ShareInterval>::none(result.pooling.reason);
        result.equality_interval = Possible<ShareInterval>::none(result.pooling.reason);
    }
    result.sentence = sentence_of(result, all.size());
    return result;
}

}  // namespace

bool is_significant(const Possible<PValue>& p) { return p.has_value() && p->p < kSignificance; }

Preference preference_of(const Votes& votes) {
    Preference preference;
    preference.votes = votes;
    if (votes.n() > 0) {
        preference.share_b = static_cast<double>(votes.b) / static_cast<double>(votes.n());
    }
    preference.chi_square = chi_square_equal_split(votes);
    preference.exact = exact_binomial(votes.b, votes.n());
    preference.wilson = wilson(votes.b, votes.n(), kConfidence);
    preference.clopper_pearson = clopper_pearson(votes.b, votes.n(), kConfidence);
    preference.cohens_g = cohens_g(votes);
    preference.posterior = posterior_flat(votes.b, votes.n(), kConfidence);
    preference.bayes_factor = bayes_factor(votes.b, votes.n());
    return preference;
}

std::vector<HypothesisResult> test_hypotheses(const std::vector<ConditionResult>& conditions,
                                              const Family& family) {
    std::vector<HypothesisResult> results;
    for (const PlannedHypothesis& planned : family.hypotheses) {
        if (!planned.is_interaction) results.push_back(tested(planned, conditions));
    }
    return results;
}

}  // namespace obscura::analysis
