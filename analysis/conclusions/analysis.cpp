// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/analysis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <future>

#include "analysis/conclusions/hypotheses.h"
#include "analysis/conclusions/model_check.h"
#include "analysis/conclusions/order.h"
#include "analysis/conclusions/participants.h"
#include "analysis/conclusions/pooled_share.h"
#include "analysis/conclusions/published_study.h"
#include "analysis/conclusions/run_power.h"
#include "analysis/conclusions/validity.h"
#include "analysis/conclusions/variant_scales.h"
#include "analysis/conclusions/verdicts.h"
#include "analysis/conclusions/words.h"
#include "analysis/statistics/benjamini_hochberg.h"
#include "analysis/statistics/exact_binomial.h"
#include "analysis/statistics/holm.h"

namespace obscura::analysis {
namespace {

std::vector<ConditionResult> test_conditions(const Tally& tally) {
    std::vector<ConditionResult> results;
    std::vector<double> family;
    for (const ConditionVotes& condition : tally.conditions) {
        ConditionResult result;
        result.condition = {condition.id,        condition.hypothesis, condition.validity,
                            condition.variant_a, condition.variant_b,  condition.votes,
                            condition.view};
        result.preference = preference_of(condition.votes);
        // The family is that of the study, whoever answered: what cannot be tested counts as 1.
        const Possible<PValue>& p = result.preference.exact;
        family.push_back(p.has_value() ? p->p : 1.0);
        results.push_back(std::move(result));
    }
    const std::vector<double> by_holm = holm(family);
    const std::vector<double> by_rate = benjamini_hochberg(family);
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (!results[i].preference.exact.has_value()) continue;
        results[i].p_holm = by_holm[i];
        results[i].p_bh = by_rate[i];
    }
    return results;
}

std::string sentence_of(const std::vector<ConditionResult>& conditions) {
    std::vector<std::string> alone;
    std::vector<std::string> corrected;
    for (const ConditionResult& result : conditions) {
        if (!result.p_holm.has_value()) continue;
        if (is_significant(result.preference.exact)) alone.push_back(result.condition.id);
        if (*result.p_holm < kSignificance) corrected.push_back(result.condition.id);
    }
    const auto list = [](const std::vector<std::string>& ids) {
        return ids.empty() ? std::string("none") : fmt::format("{}", fmt::join(ids, ", "));
    };
    return fmt::format(
        "Significant at {:g} each for itself: {}. Still so after Holm's correction for {}: "
        "{}.",
        kSignificance, list(alone), counted(static_cast<std::int64_t>(conditions.size()), "test"),
        list(corrected));
}

std::vector<OrderStratum> order_strata(const Tally& tally) {
    std::vector<OrderStratum> strata;
    for (const ConditionVotes& condition : tally.conditions) {
        OrderStratum& stratum = strata.emplace_back();
        for (const Answer& answer : condition.answers) {
            Votes& votes = answer.b_second ? stratum.b_second : stratum.b_first;
            ++(answer.chose_b ? votes.b : votes.a);
        }
    }
    return strata;
}

/// What needs to know who gave each answer.
void analyse_participants(Analysis& analysis) {
    const Tally& tally = analysis.tally;
    const VotesByParticipant votes(tally);
    if (analysis.order_bias.has_value()) {
        analysis.order_bias.value->by_participant = order_by_participant(votes);
    }
    analysis.attention = attention_of(tally, votes);
    analysis.response_times = response_times(tally, votes);
    analysis.learning = learning_of(tally, votes);
}

/// The analysis of all who are in the tally.
Analysis analyse_all(Tally tally, const AnalysisOptions& options) {
    Analysis analysis;
    analysis.tally = std::move(tally);
    if (is_published_votes(analysis.tally)) add_published_views(analysis.tally);
    analysis.conditions = test_conditions(analysis.tally);
    analysis.sentence = sentence_of(analysis.conditions);
    analysis.family = family_of(analysis.tally);
    analysis.look = look_of(analysis.tally);
    analysis.hypotheses = test_hypotheses(analysis.conditions, analysis.family);
    analysis.validity = test_validity(analysis.tally, analysis.family);
    // Beside what follows: of many answers it takes as long as all of that.
    auto scales =
        std::async(std::launch::async, [&analysis] { return variant_scales(analysis.tally); });
    const Possible<OrderVotes>& order = analysis.tally.order;
    if (order.has_value()) {
        analysis.order_bias = OrderBias{*order, exact_binomial(order->second_chosen, order->n),
                                        Possible<OrderByParticipant>::none("not known"),
                                        order_bias(order_strata(analysis.tally))};
    } else {
        analysis.order_bias = Possible<OrderBias>::none(order.reason);
    }
    if (analysis.tally.participants.empty()) {
        const char* const why = "the answers of each participant are not known";
        analysis.response_times = Possible<ResponseTimes>::none(why);
        analysis.learning = Possible<Learning>::none(why);
    } else {
        analyse_participants(analysis);
    }
    infer_pooled_shares(analysis.hypotheses, analysis.tally);
    analysis.scales = scales.get();
    analysis.has_model = options.model && !analysis.tally.participants.empty();
    if (analysis.has_model) check_by_model(analysis);
    analysis.power = run_power(analysis.conditions);
    analysis.verdicts = verdicts_of(analysis);
    return analysis;
}

std::vector<bool> left_out_by(const Attention& attention) {
    std::vector<bool> left_out;
    for (const ParticipantResult& who : attention.participants) {
        left_out.push_back(!who.left_out.empty());
    }
    return left_out;
}

/// What verdicts rest on, of all who are in the tally.
std::vector<Verdict> verdicts_of_all(Tally tally) {
    Analysis analysis;
    analysis.tally = std::move(tally);
    for (const ConditionVotes& condition : analysis.tally.conditions) {
        ConditionResult& result = analysis.conditions.emplace_back();
        result.condition = {condition.id,        condition.hypothesis, condition.validity,
                            condition.variant_a, condition.variant_b,  condition.votes,
                            condition.view};
    }
    analysis.family = family_of(analysis.tally);
    analysis.hypotheses = test_hypotheses(analysis.conditions, analysis.family);
    analysis.validity = test_validity(analysis.tally, analysis.family);
    infer_pooled_shares(analysis.hypotheses, analysis.tally, PooledParts::kVerdict);
    return verdicts_of(analysis);
}

}  // namespace

std::vector<Verdict> verdicts_on(Tally tally) {
    if (tally.exclusion.has_value() && !tally.participants.empty()) {
        const Attention attention = attention_of(tally, VotesByParticipant(tally));
        return verdicts_of_all(without(tally, left_out_by(attention)));
    }
    return verdicts_of_all(std::move(tally));
}

Analysis analyse(Tally tally, const AnalysisOptions& options) {
    Analysis everybody = analyse_all(std::move(tally), options);
    if (!everybody.tally.exclusion.has_value()) {
        everybody.exclusions = Possible<Exclusions>::none(everybody.tally.exclusion.reason);
        return everybody;
    }
    const std::vector<bool> left_out = left_out_by(*everybody.attention);
    Exclusions exclusions;
    exclusions.rule = *everybody.tally.exclusion;
    exclusions.participants = static_cast<std::int64_t>(left_out.size());
    exclusions.left_out = std::count(left_out.begin(), left_out.end(), true);
    if (exclusions.left_out == 0) {
        everybody.exclusions = exclusions;
        return everybody;
    }
    Tally kept = without(everybody.tally, left_out);
    for (ConditionVotes& condition : everybody.tally.conditions) {
        condition.answers = std::vector<Answer>();
    }
    Analysis analysis = analyse_all(std::move(kept), options);
    analysis.attention = everybody.attention;
    exclusions.changes = changed_conclusions(analysis, everybody);
    exclusions.everybody = std::make_shared<const Analysis>(std::move(everybody));
    analysis.exclusions = exclusions;
    return analysis;
}

}  // namespace obscura::analysis
