// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/json_sections.h"

namespace obscura::analysis {
namespace {

void put_values(Json& object, const std::string& name, const VariantScale& scale,
                const Possible<Scale>& values) {
    if (!values.has_value()) return put_none(object, name, values.reason);
    object[name] = Json::array();
    for (std::size_t i = 0; i < scale.variants.size(); ++i) {
        Json& entry = object[name].emplace_back();
        entry["variant"] = scale.variants[i];
        entry["value"] = values->values[i];
        if (scale.jod_intervals.has_value()) {
            entry["standard_error"] = values->standard_errors[i];
        } else {
            put_none(entry, "standard_error", scale.jod_intervals.reason);
        }
    }
    if (!scale.has_order_term) return;
    object[name + "_order_term"] = values->order_term;
    if (scale.jod_intervals.has_value()) {
        object[name + "_order_standard_error"] = values->order_standard_error;
    }
}

std::string_view source_of(ScaleErrors errors) {
    switch (errors) {
        case ScaleErrors::kParticipants:
            return "participants";
        case ScaleErrors::kVotes:
            return "votes_taken_as_independent";
        case ScaleErrors::kPrior:
            return "posterior";
    }
    return "";
}

Json term_json(const ModelTerm& term) {
    Json object;
    object["log_odds"] = term.log_odds;
    object["standard_error"] = term.standard_error;
    put_interval(object, "log_odds", Possible<Interval>(term.interval));
    put_p(object, "p", Possible<PValue>(term.p));
    return object;
}

}  // namespace

void put_scale(Json& object, const VariantScale& scale) {
    object["variants"] = scale.variants;
    object["reference"] = scale.variants.front();
    object["standard_errors_from"] = source_of(scale.errors);
    put_values(object, "bradley_terry", scale, scale.bradley_terry);
    put_values(object, "thurstone_jod", scale, scale.thurstone);
    if (scale.jod_intervals.has_value() && scale.thurstone.has_value()) {
        for (std::size_t i = 0; i < scale.variants.size(); ++i) {
            put_interval(object["thurstone_jod"][i], "value",
                         Possible<Interval>((*scale.jod_intervals)[i]));
        }
    }
    if (!scale.separated.empty()) {
        object["separated"] = scale.separated;
        object["prior_sd_jod"] = kScalePriorJod;
    }
}

void put_model(Json& object, const Possible<ModelCheck>& model) {
    if (!model.has_value()) return put_none(object, "model", model.reason);
    Json& entry = object["model"];
    entry["n_participants"] = model->participants;
    entry["quadrature_nodes"] = model->nodes;
    if (model->effect.has_value()) {
        entry["effect"] = term_json(*model->effect);
    } else {
        put_none(entry, "effect", model->effect.reason);
    }
    if (model->order.has_value()) {
        entry["order"] = term_json(*model->order);
    } else {
        put_none(entry, "order", model->order.reason);
    }
    entry["participants_sd"] = model->sd;
    if (model->conditions_differ.has_value()) {
        entry["conditions_differ"] = {{"likelihood_ratio", model->conditions_differ->statistic},
                                      {"df", model->conditions_differ->df},
                                      {"error_df", model->conditions_differ->error_df}};
        put_p(entry["conditions_differ"], "p", Possible<PValue>(model->conditions_differ->p));
    } else {
        put_none(entry, "conditions_differ", model->conditions_differ.reason);
    }
}

}  // namespace obscura::analysis
