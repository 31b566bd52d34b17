// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/json_report.h"

#include "analysis/presentation/json_sections.h"
#include "analysis/presentation/questions_text.h"

namespace obscura::analysis {
namespace {

void put_chi_square(Json& object, const Possible<ChiSquareTest>& test) {
    if (!test.has_value()) {
        for (const char* name : {"chi_square", "df", "p_value"}) {
            put_none(object, name, test.reason);
        }
        return;
    }
    object["chi_square"] = test->statistic;
    object["df"] = test->df;
    put_p(object, "p_value", test->p);
}

/// The posterior of the share of B with a flat prior, and the Bayes factor.
void put_belief(Json& object, const Preference& preference) {
    if (preference.posterior.has_value()) {
        object["posterior_mean"] = preference.posterior->mean;
        put_interval(object, "posterior", Possible<Interval>(preference.posterior->interval));
        put_p(object, "probability_b_preferred", preference.posterior->above_half);
    } else {
        for (const char* name :
             {"posterior_mean", "posterior_low", "posterior_high", "probability_b_preferred"}) {
            put_none(object, name, preference.posterior.reason);
        }
    }
    if (preference.bayes_factor.has_value()) {
        put(object, "bf10", preference.bayes_factor->bf10);
        object["log10_bf10"] = preference.bayes_factor->log10_bf10;
    } else {
        put_none(object, "bf10", preference.bayes_factor.reason);
        put_none(object, "log10_bf10", preference.bayes_factor.reason);
    }
}

void put_votes(Json& object, const Votes& votes) {
    object["n"] = votes.n();
    object["count_a"] = votes.a;
    object["count_b"] = votes.b;
}

void put_preference(Json& object, const Preference& preference) {
    put_chi_square(object, preference.chi_square);
    put_p(object, "p_exact", preference.exact);
    put(object, "share_b", preference.share_b);
    put_interval(object, "wilson", preference.wilson);
    put_interval(object, "clopper_pearson", preference.clopper_pearson);
    put(object, "cohens_g", preference.cohens_g);
    put_belief(object, preference);
}

Json condition_json(const ConditionResult& result) {
    Json object;
    object["id"] = result.condition.id;
    object["hypothesis"] = result.condition.hypothesis;
    object["validity"] = result.condition.validity;
    object["variant_a"] = result.condition.variant_a;
    object["variant_b"] = result.condition.variant_b;
    put(object, "view",
        result.condition.view.empty() ? Possible<std::string>::none("not known")
                                      : Possible<std::string>(result.condition.view));
    put_votes(object, result.condition.votes);
    put_preference(object, result.preference);
    put(object, "p_holm", result.p_holm);
    put(object, "p_bh", result.p_bh);
    return object;
}

std::string_view source_of(ShareIntervalKind kind) {
    switch (kind) {
        case ShareIntervalKind::kMeans:
            return "t_of_participants";
        case ShareIntervalKind::kEachOnce:
            return "clopper_pearson_of_participants";
        case ShareIntervalKind::kCounts:
            return "clopper_pearson_of_people";
    }
    return "";
}

/// An interval of the pooled share, with what it rests on.
void put_share_interval(Json& object, const std::string& name,
                        const Possible<ShareInterval>& interval) {
    put_interval(object, name,
                 interval.has_value() ? Possible<Interval>(interval->bounds)
                                      : Possible<Interval>::none(interval.reason));
    if (interval.has_value()) object[name + "_from"] = source_of(interval->kind);
}

/// Whether the conditions of a hypothesis differ.
void put_heterogeneity(Json& object, const Possible<Heterogeneity>& heterogeneity) {
    if (!heterogeneity.has_value()) {
        return put_none(object, "heterogeneity", heterogeneity.reason);
    }
    Json& entry = object["heterogeneity"];
    entry["n_participants"] = heterogeneity->participants;
    entry["cochran_q"] = heterogeneity->test.statistic;
    entry["df"] = heterogeneity->test.df;
    put_p(entry, "p", Possible<PValue>(heterogeneity->test.p));
}

Json hypothesis_json(const HypothesisResult& result) {
    Json object;
    object["conditions"] = result.conditions;
    object["not_answered"] = result.unanswered;
    if (result.pooling.has_value()) {
        object["pooled_as"] = result.pooling->words;
        put_votes(object, result.pooled.votes);
    } else {
        for (const char* name : {"pooled_as", "n", "count_a", "count_b"}) {
            put_none(object, name, result.pooling.reason);
        }
    }
    Preference shown = result.pooled;
    shown.posterior = result.posterior;
    put_preference(object, shown);
    object["take_votes_as_independent"] = {"chi_square", "p_value", "p_exact"};
    put_p(object, "p_each_once", result.each_once);
    put_heterogeneity(object, result.heterogeneity);
    put_model(object, result.model);
    if (result.by_participant.has_value()) {
        object["n_participants_with_preference"] = result.by_participant->participants;
        object["by_participant_exact"] = result.by_participant->is_exact;
        put_p(object, "p_by_participant", Possible<PValue>(result.by_participant->p));
    } else {
        put_none(object, "p_by_participant", result.by_participant.reason);
    }
    put_share_interval(object, "share_b_interval", result.interval);
    put_share_interval(object, "share_b_interval_90", result.equality_interval);
    object["secondary"] = result.secondary;
    object["n_significant"] = result.significant;
    object["n_significant_holm"] = result.significant_holm;
    object["sentence"] = result.sentence;
    return object;
}

Json same_participants_json(const SameParticipants& same) {
    Json object;
    object["n"] = same.n;
    object["incomplete"] = same.incomplete;
    if (same.cochran_q.has_value()) {
        object["cochran_q"] = same.cochran_q->statistic;
        object["df"] = same.cochran_q->df;
        put_p(object, "p_cochran", same.cochran_q->p);
    } else {
        for (const char* name : {"cochran_q", "df", "p_cochran"}) {
            put_none(object, name, same.cochran_q.reason);
        }
    }
    if (!same.mcnemar.has_value()) {
        put_none(object, "mcnemar", same.mcnemar.reason);
        return object;
    }
    Json& mcnemar = object["mcnemar"];
    mcnemar["b_to_a"] = same.changed.a;
    mcnemar["a_to_b"] = same.changed.b;
    mcnemar["chi_square"] = same.mcnemar->uncorrected.statistic;
    put_p(mcnemar, "p_value", same.mcnemar->uncorrected.p);
    mcnemar["chi_square_corrected"] = same.mcnemar->corrected.statistic;
    put_p(mcnemar, "p_corrected", same.mcnemar->corrected.p);
    put_p(mcnemar, "p_exact", same.mcnemar->exact);
    return object;
}

Json comparison_json(const Comparison& comparison) {
    Json object;
    object["variant_a"] = comparison.variant_a;
    object["variant_b"] = comparison.variant_b;
    put(object, "view",
        comparison.view.empty() ? Possible<std::string>::none("several")
                                : Possible<std::string>(comparison.view));
    object["conditions"] = comparison.conditions;
    object["votes"] = Json::array();
    for (std::size_t i = 0; i < comparison.votes.size(); ++i) {
        object["votes"].push_back({{"validity", comparison.levels[i]},
                                   {"count_a", comparison.votes[i].a},
                                   {"count_b", comparison.votes[i].b}});
    }
    put_chi_square(object, comparison.test);
    put_p(object, "p_fisher", comparison.fisher);
    if (comparison.same_participants.has_value()) {
        object["same_participants"] = same_participants_json(*comparison.same_participants);
    } else {
        put_none(object, "same_participants", comparison.same_participants.reason);
    }
    if (comparison.contrast.has_value()) {
        const LevelContrast& contrast = *comparison.contrast;
        Json& entry = object["contrast"];
        entry["n_participants"] = contrast.n;
        entry["left_out"] = contrast.left_out;
        entry["n_scenes"] = contrast.scenes;
        entry["is_exact"] = contrast.is_exact;
        put_p(entry, "p", Possible<PValue>(contrast.p));
    } else {
        put_none(object, "contrast", comparison.contrast.reason);
    }
    object["differences"] = Json::array();
    for (const LevelDifference& difference : comparison.differences) {
        object["differences"].push_back({{"from", comparison.levels[difference.from]},
                                         {"to", comparison.levels[difference.to]},
                                         {"difference", difference.difference},
                                         {"difference_low", difference.interval.low},
                                         {"difference_high", difference.interval.high},
                                         {"difference_low_90", difference.equality.low},
                                         {"difference_high_90", difference.equality.high},
                                         {"interval_from", to_string(difference.kind)}});
    }
    put_model(object, comparison.model);
    put_p(object, "p", p_of(comparison));
    object["test"] = test_words(comparison);
    return object;
}

void add_validity(Json& hypothesis, const ValidityResult& result) {
    hypothesis["comparisons"] = Json::array();
    for (const Comparison& comparison : result.by_level) {
        hypothesis["comparisons"].push_back(comparison_json(comparison));
    }
    hypothesis["without_partner"] = result.without_partner;
    if (!result.across_scenes.empty()) {
        Json& list = hypothesis["across_scenes"] = Json::array();
        for (const Comparison& comparison : result.across_scenes) {
            list.push_back(comparison_json(comparison));
        }
    }
    hypothesis["pairs"] = Json::array();
    for (const Comparison& pair : result.by_pair) {
        hypothesis["pairs"].push_back(comparison_json(pair));
    }
    hypothesis["sentence"] = result.sentence;
}

void put_order_bias(Json& object, const Possible<OrderBias>& bias) {
    if (!bias.has_value()) {
        put_none(object, "order_bias", bias.reason);
        return;
    }
    Json entry;
    entry["n"] = bias->votes.n;
    entry["second_chosen"] = bias->votes.second_chosen;
    put_p(entry, "p_exact", bias->exact);
    if (bias->logistic.has_value()) {
        const OrderBiasTest& test = *bias->logistic;
        Json& logistic = entry["logistic"];
        logistic["conditions"] = test.conditions;
        logistic["order_term"] = test.order_term;
        logistic["standard_error"] = test.standard_error;
        logistic["second_share"] = test.second_share;
        put_chi_square(logistic, test.likelihood_ratio);
    } else {
        put_none(entry, "logistic", bias->logistic.reason);
    }
    if (bias->by_participant.has_value()) {
        const OrderByParticipant& order = *bias->by_participant;
        Json& own = entry["by_participant"];
        own["test"] = order.kind == OrderTestKind::kSideGroups ? "side_groups" : "sign_flip";
        own["n_participants"] = order.participants;
        own["left_out"] = order.left_out;
        own["is_exact"] = order.is_exact;
        put_p(own, "p", Possible<PValue>(order.p));
        own["difference"] = order.difference;
        put_interval(own, "difference", order.interval);
    } else {
        put_none(entry, "by_participant", bias->by_participant.reason);
    }
    object["order_bias"] = entry;
}

/// What the answers say, without who gave them.
void put_results(Json& report, const Analysis& analysis) {
    put(report, "n_participants", analysis.tally.n_participants);
    report["conditions"] = Json::array();
    for (const ConditionResult& result : analysis.conditions) {
        report["conditions"].push_back(condition_json(result));
    }
    report["sentence"] = analysis.sentence;
    report["hypotheses"] = Json::object();
    for (const HypothesisResult& result : analysis.hypotheses) {
        report["hypotheses"][result.name] = hypothesis_json(result);
    }
    if (analysis.validity.has_value()) {
        report["validity_question"] = analysis.validity->name;
        add_validity(report["hypotheses"][analysis.validity->name], *analysis.validity);
    } else {
        put_none(report, "validity_question", analysis.validity.reason);
    }
    for (const Verdict& verdict : analysis.verdicts) {
        put_verdict(report["hypotheses"][verdict.hypothesis], verdict);
    }
    put_order_bias(report, analysis.order_bias);
    report["scales"] = Json::array();
    for (const VariantScale& scale : analysis.scales)
        put_scale(report["scales"].emplace_back(), scale);
}

}  // namespace

std::string json_report(const Analysis& analysis, const QuestionsResult* questions) {
    const Tally& tally = analysis.tally;
    Json report;
    report["source"] = tally.source;
    if (tally.study.empty()) {
        put_none(report, "study", "the counts do not say");
    } else {
        report["study"] = tally.study;
    }
    if (tally.kind) {
        report["kind"] = to_string(*tally.kind);
        report["simulated"] = *tally.kind == Kind::kSimulated;
    } else {
        put_none(report, "kind", "the counts do not say");
        put_none(report, "simulated", "the counts do not say");
    }
    report["family"] = analysis.family.words;
    put_registration(report, analysis.registration);
    put_look(report, analysis.look);
    report["significance_level"] = kSignificance;
    report["confidence"] = kConfidence;
    put_results(report, analysis);
    report["verdict_rule"] = verdict_rule();
    put_power(report, analysis.power);
    put_attention(report, analysis.attention);
    put_response_times(report, analysis);
    put_learning(report, analysis.learning);
    put_exclusions(report, analysis.exclusions);
    if (analysis.exclusions.has_value() && analysis.exclusions->everybody) {
        put_results(report["exclusions"]["everybody"], *analysis.exclusions->everybody);
    }
    if (questions != nullptr) put_questions(report, *questions);
    return report.dump(2) + '\n';
}

}  // namespace obscura::analysis
