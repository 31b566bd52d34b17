// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/observer_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "renderer/base/error.h"

namespace obscura::app {
namespace {

constexpr double kLargestSd = 10.0;

/// The conditions whose share can be given: attention checks and repeats follow from others.
std::vector<std::string> votable(const stimuli::Study& study) {
    std::vector<std::string> ids;
    for (const stimuli::Condition& condition : study.conditions) {
        if (!condition.practice && condition.expected == '\0' && condition.repeats.empty())
            ids.push_back(condition.id);
    }
    return ids;
}

double share_from(const std::string& text, const std::string& option) {
    double share = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), share);
    const bool is_number = error == std::errc() && end == text.data() + text.size();
    if (!is_number || !(share >= 0.0 && share <= 1.0)) {
        throw base::bad_input(
            "--share {}: allowed is a share of B from 0 to 1, or CONDITION=SHARE, as in I=.6",
            option);
    }
    return share;
}

void check(const ObserverOptions& options) {
    if (!(options.sd >= 0.0 && options.sd <= kLargestSd)) {
        throw base::bad_input("--sd {}: allowed is 0 to {}, in log odds", options.sd, kLargestSd);
    }
    if (!(options.order_bias > 0.0 && options.order_bias < 1.0)) {
        throw base::bad_input("--order-bias {}: allowed is more than 0 and less than 1",
                              options.order_bias);
    }
    if (!(options.careless >= 0.0 && options.careless <= 1.0)) {
        throw base::bad_input("--careless {}: allowed is 0 to 1", options.careless);
    }
}

}  // namespace

std::vector<Option> add_own_options(const Options& app, ObserverOptions& options) {
    return {app.add("--sd", options.sd,
                    "Standard deviation between observers of how much they like B, in log odds, "
                    "the same in all conditions")
                .shows_default(),
            app.add("--order-bias", options.order_bias,
                    "Share of answers for the second image where neither is preferred")
                .shows_default(),
            app.add("--careless", options.careless,
                    "Share of observers who answer by chance whatever they see")
                .shows_default()};
}

void add_observer_options(const Options& app, ObserverOptions& options) {
    app.add("--share", options.shares,
            "True share of votes for B, 0 to 1: in one condition (I=.6), or in all that are not "
            "named "
            "(.6); repeatable (default: .5)")
        .type("[CONDITION=]SHARE")
        .repeatable();
    (void)add_own_options(app, options);
}

kiosk::ChoiceModel choices_from(const ObserverOptions& options, const stimuli::Study& study) {
    check(options);
    kiosk::ChoiceModel model = kiosk::choices_from(study, {});
    model.sd = options.sd;
    model.order_bias = options.order_bias;
    model.careless = options.careless;
    kiosk::set_share(model, study, "", 0.5);
    const std::vector<std::string> allowed = votable(study);
    std::vector<std::pair<std::string, double>> named;
    for (const std::string& option : options.shares) {
        const std::size_t equals = option.rfind('=');
        if (equals == std::string::npos) {
            kiosk::set_share(model, study, "", share_from(option, option));
            continue;
        }
        named.emplace_back(option.substr(0, equals), share_from(option.substr(equals + 1), option));
        if (std::find(allowed.begin(), allowed.end(), named.back().first) == allowed.end()) {
            throw base::bad_input(
                "--share {}: the study {} has no condition {} to vote on, allowed "
                "are {}",
                option, study.name, named.back().first, fmt::join(allowed, ", "));
        }
    }
    for (const auto& [id, share] : named) kiosk::set_share(model, study, id, share);
    return model;
}

}  // namespace obscura::app
