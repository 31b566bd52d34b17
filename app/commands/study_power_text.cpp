// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/study_power_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/presentation/text_layout.h"

namespace obscura::app {
namespace {

using Json = nlohmann::ordered_json;

/// `64.0 % +- 1.5`: what the simulation leaves uncertain, one standard error.
std::string in_percent(const Frequency& frequency) {
    return fmt::format("{:.1f} % +- {:.1f}", 100.0 * frequency.share(), 100.0 * frequency.error());
}

std::string observers_words(const PowerRequest& request) {
    return fmt::format(
        "observers who differ in what they like by a standard deviation of {:g} in log odds, "
        "choose the second of two alike images in {:g} %, and of whom {:g} % answer by chance",
        request.sd, 100.0 * request.order_bias, 100.0 * request.careless);
}

/// What the study fixes and the simulation passes over, in sentences.
std::vector<std::string> passed_over(const stimuli::Study& study) {
    std::vector<std::string> words;
    if (study.stopping.looks.size() > 1) {
        words.push_back(fmt::format(
            "The study's [stopping] is not simulated: {} looks are planned, and here the answers "
            "are looked at once, at the last. Spending the level over looks costs some of this "
            "power.",
            study.stopping.looks.size()));
    }
    if (study.exclusion.min_response_time_s) {
        words.push_back(fmt::format(
            "The study's rule on response times (a median of {:g} s at least) leaves out nobody "
            "here: the simulated observers take no time.",
            *study.exclusion.min_response_time_s));
    }
    return words;
}

Json json_of(const Frequency& frequency) {
    return {{"participants", frequency.participants},
            {"studies", frequency.studies},
            {"frequency", frequency.share()},
            {"standard_error", frequency.error()}};
}

}  // namespace

std::string study_power_text(const stimuli::Study& study, const PowerRequest& request,
                             const std::vector<VerdictPower>& results) {
    std::vector<analysis::TextRow> rows{{"hypothesis", "true", "verdict"}};
    if (request.participants) {
        rows.front().push_back(fmt::format("at {}", *request.participants));
    }
    if (request.asks_needed) {
        rows.front().push_back(fmt::format("participants for {:g} %", 100.0 * request.power));
        rows.front().emplace_back("there");
    }
    for (const VerdictPower& result : results) {
        rows.push_back({result.hypothesis + (result.is_primary ? "" : " (secondary)"), result.truth,
                        result.verdict});
        if (request.participants) rows.back().push_back(in_percent(*result.at));
        if (!request.asks_needed) continue;
        rows.back().push_back(result.needed.has_value()
                                  ? std::to_string(result.needed->participants)
                              : result.is_true ? result.needed.reason
                                               : "-");
        rows.back().push_back(result.needed.has_value() ? in_percent(*result.needed) : "-");
    }
    std::string text = fmt::format(
        "Power of the verdicts on the study {}, by simulating it as planned (order {}, sides {}, "
        "its family of hypotheses and its rule of exclusion): {}. {} studies for each number, seed "
        "{}; behind each frequency its standard error from that. What is true is true of that "
        "hypothesis only, and the answers are looked at once.",
        study.name, to_string(study.order), to_string(study.sides), observers_words(request),
        request.studies, request.seed);
    for (const std::string& words : passed_over(study)) text += ' ' + words;
    if (request.asks_needed) {
        text += fmt::format(
            " Numbers of participants are whole blocks of {}, looked for with up to 400 studies "
            "each.",
            stimuli::block_size(study.order, study.pair_count()));
    }
    return analysis::wrapped(text + '\n') + '\n' + analysis::aligned(rows, 3);
}

std::string study_power_json(const stimuli::Study& study, const PowerRequest& request,
                             const std::vector<VerdictPower>& results) {
    Json report;
    report["study"] = study.name;
    report["sides"] = to_string(study.sides);
    report["order"] = to_string(study.order);
    report["sd"] = request.sd;
    report["order_bias"] = request.order_bias;
    report["careless"] = request.careless;
    report["studies"] = request.studies;
    report["seed"] = request.seed;
    report["power"] = request.power;
    report["not_simulated"] = passed_over(study);
    report["verdicts"] = Json::array();
    for (const VerdictPower& result : results) {
        Json& entry = report["verdicts"].emplace_back();
        entry["hypothesis"] = result.hypothesis;
        entry["role"] = result.is_primary ? "primary" : "secondary";
        entry["true"] = result.truth;
        entry["verdict"] = result.verdict;
        entry["is_error"] = !result.is_true;
        entry["at"] = result.at ? json_of(*result.at) : Json();
        entry["needed"] = result.needed.has_value() ? json_of(*result.needed) : Json();
        if (!result.needed.has_value()) entry["needed_reason"] = result.needed.reason;
    }
    return report.dump(2) + '\n';
}

}  // namespace obscura::app
