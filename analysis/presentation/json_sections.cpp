// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/json_sections.h"

#include <fmt/format.h>

namespace obscura::analysis {
namespace {

void put_test_power(Json& object, const std::string& name, const TestPower& power) {
    put(object, name + "_critical_votes", power.critical_votes);
    object[name + "_power"] = power.power;
    object[name + "_true_size"] = power.true_size;
}

void put_successes(Json& object, const std::string& name, const Successes& trials) {
    object[name] = {{"n", trials.n}, {"successes", trials.successes}};
}

void put_quartiles(Json& object, const std::string& name, const Possible<Quartiles>& parts) {
    if (!parts.has_value()) return put_none(object, name, parts.reason);
    object[name] = {{"n", parts->n},
                    {"first_quartile", parts->first},
                    {"median", parts->median},
                    {"third_quartile", parts->third}};
}

Json participant_json(const ParticipantResult& who) {
    Json object;
    object["participant"] = who.id;
    object["n_votes"] = who.votes;
    put_successes(object, "catch_trials", who.catch_trials);
    put_successes(object, "repeats", who.repeats);
    put_successes(object, "with_majority", who.with_majority);
    put(object, "median_response_time_s", who.median_time_s);
    object["left_out"] = who.left_out;
    return object;
}

Json times_json(const ResponseTimeSummary& times) {
    Json object;
    object["n_participants"] = times.seconds.n;
    object["first_quartile_s"] = times.seconds.first;
    object["median_s"] = times.seconds.median;
    object["third_quartile_s"] = times.seconds.third;
    put_interval(object, "median_s", times.median_interval);
    return object;
}

}  // namespace

void put_verdict(Json& hypothesis, const Verdict& verdict) {
    hypothesis["verdict"] = verdict_words(verdict);
    hypothesis["verdict_sentence"] = verdict.sentence;
    put_p(hypothesis, "verdict_p", verdict.p);
    put(hypothesis, "verdict_p_holm", verdict.p_holm);
    put_interval(hypothesis, "verdict_interval", verdict.interval);
    put_interval(hypothesis, "verdict_interval_90", verdict.equality);
    hypothesis["statement"] = verdict.statement;
    hypothesis["role"] = verdict.is_primary ? "primary" : "secondary";
    hypothesis["margin"] = verdict.margin;
    for (const ComparedVerdict& compared : verdict.compared) {
        Json& entry = hypothesis["verdict_comparisons"].emplace_back();
        entry["conditions"] = compared.conditions;
        put_p(entry, "p", compared.p);
        put(entry, "p_holm", compared.p_holm);
        put_interval(entry, "interval", compared.interval);
    }
    if (verdict.is_on_validity) hypothesis["is_on_validity"] = true;
}

void put_registration(Json& report, const Possible<RegistrationResult>& registration) {
    if (!registration.has_value()) return put_none(report, "registration", registration.reason);
    report["registration"] = {{"document", registration->document},
                              {"written_utc", registration->written_utc},
                              {"deviations", registration->deviations},
                              {"unknown", registration->unknown}};
}

void put_look(Json& report, const Possible<LookResult>& look) {
    if (!look.has_value()) return put_none(report, "look", look.reason);
    report["look"] = {{"number", look->looks.size()},
                      {"looks", look->looks},
                      {"planned", look->planned},
                      {"is_planned", look->is_planned},
                      {"is_interim", look->is_interim},
                      {"spending", to_string(look->spending)},
                      {"spent", look->boundary.spent},
                      {"boundary_z", look->boundary.z},
                      {"boundary_p", look->boundary.p},
                      {"error", look->error},
                      {"words", look->words}};
}

void put_power(Json& report, const Possible<RunPower>& power) {
    if (!power.has_value()) return put_none(report, "power", power.reason);
    Json object;
    object["n"] = power->n;
    object["tests"] = power->tests;
    object["at_shares"] = Json::array();
    for (const RunPower::At& at : power->shares) {
        Json& entry = object["at_shares"].emplace_back();
        entry["share"] = at.share;
        put_test_power(entry, "exact", at.exact);
        put_test_power(entry, "chi_square", at.chi_square);
        put_test_power(entry, "exact_holm", at.holm);
    }
    object["asked_power"] = kAskedPower;
    put(object, "detectable_share", power->detectable);
    put(object, "detectable_share_holm", power->detectable_holm);
    report["power"] = std::move(object);
}

void put_attention(Json& report, const Possible<Attention>& attention) {
    if (!attention.has_value()) return put_none(report, "attention", attention.reason);
    Json object;
    put_successes(object, "catch_trials", attention->catch_trials);
    put_successes(object, "repeats", attention->repeats);
    put_quartiles(object, "catch_share", attention->catch_share);
    put_quartiles(object, "repeat_share", attention->repeat_share);
    put_quartiles(object, "majority_share", attention->majority_share);
    if (attention->participants.size() > kMostListed) {
        put_none(object, "participants", fmt::format("more than {}", kMostListed));
    } else {
        object["participants"] = Json::array();
        for (const ParticipantResult& who : attention->participants) {
            object["participants"].push_back(participant_json(who));
        }
    }
    report["attention"] = std::move(object);
}

void put_response_times(Json& report, const Analysis& analysis) {
    const Possible<ResponseTimes>& times = analysis.response_times;
    if (!times.has_value()) return put_none(report, "response_times", times.reason);
    Json object;
    object["overall"] = times_json(times->overall);
    object["conditions"] = Json::array();
    for (std::size_t i = 0; i < times->by_condition.size(); ++i) {
        const Possible<ResponseTimeSummary>& own = times->by_condition[i];
        Json entry;
        entry["id"] = analysis.conditions[i].condition.id;
        if (own.has_value()) {
            entry.update(times_json(*own));
        } else {
            put_none(entry, "median_s", own.reason);
        }
        object["conditions"].push_back(std::move(entry));
    }
    report["response_times"] = std::move(object);
}

void put_learning(Json& report, const Possible<Learning>& learning) {
    if (!learning.has_value()) return put_none(report, "learning", learning.reason);
    Json object;
    if (learning->time.has_value()) {
        Json& time = object["response_time"];
        time["n_participants"] = learning->time->participants;
        time["slope_s"] = learning->time->slope_s;
        put_interval(time, "slope_s", learning->time->interval);
    } else {
        put_none(object, "response_time", learning->time.reason);
    }
    if (learning->choice.has_value()) {
        const StratifiedSlope& slope = *learning->choice;
        Json& choice = object["choice_of_b"];
        choice["log_odds_slope"] = slope.slope;
        choice["standard_error"] = slope.standard_error;
        choice["conditions"] = slope.strata;
        choice["likelihood_ratio"] = slope.likelihood_ratio.statistic;
        put_p(choice, "p_value", Possible<PValue>(slope.likelihood_ratio.p));
    } else {
        put_none(object, "choice_of_b", learning->choice.reason);
    }
    report["learning"] = std::move(object);
}

void put_exclusions(Json& report, const Possible<Exclusions>& exclusions) {
    if (!exclusions.has_value()) return put_none(report, "exclusions", exclusions.reason);
    Json object;
    const ExclusionRule& rule = exclusions->rule;
    object["rule"] = Json::object();
    if (rule.min_catch_correct) object["rule"]["min_catch_correct"] = *rule.min_catch_correct;
    if (rule.min_repeat_agreement) {
        object["rule"]["min_repeat_agreement"] = *rule.min_repeat_agreement;
    }
    if (rule.min_response_time_s) object["rule"]["min_response_time_s"] = *rule.min_response_time_s;
    object["n_participants"] = exclusions->participants;
    object["n_left_out"] = exclusions->left_out;
    object["changes"] = exclusions->changes;
    report["exclusions"] = std::move(object);
}

}  // namespace obscura::analysis
