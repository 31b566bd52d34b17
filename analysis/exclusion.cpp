// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/exclusion.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

struct Key {
    const char* name;
    std::optional<double> ExclusionRule::*member;
    double most;
};
constexpr std::array kKeys{
    Key{"min_catch_correct", &ExclusionRule::min_catch_correct, 1.0},
    Key{"min_repeat_agreement", &ExclusionRule::min_repeat_agreement, 1.0},
    Key{"min_response_time_s", &ExclusionRule::min_response_time_s, 86'400.0},
};

constexpr const char* kAllowed =
    "is nothing, or a JSON object with any of min_catch_correct (0 to 1), min_repeat_agreement (0 "
    "to 1), min_response_time_s (0 to 86400)";

/// Nothing where the text is no rule.
std::optional<ExclusionRule> parsed(std::string_view text) {
    ExclusionRule rule;
    if (text.empty()) return rule;
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    for (const auto& [name, value] : json.items()) {
        bool known = false;
        for (const Key& key : kKeys) {
            if (name != key.name || !value.is_number()) continue;
            const double number = value.get<double>();
            known = number >= 0.0 && number <= key.most;  // negated by NaN
            rule.*key.member = number;
        }
        if (!known) return std::nullopt;
    }
    return rule;
}

}  // namespace

std::optional<std::string> exclusion_problem(std::string_view text) {
    if (parsed(text)) return std::nullopt;
    return kAllowed;
}

ExclusionRule exclusion_rule(std::string_view text, std::string_view where) {
    const auto rule = parsed(text);
    if (!rule) {
        throw base::bad_input("{}: exclusion is '{}', allowed {}", where, text, kAllowed);
    }
    return *rule;
}

}  // namespace obscura::analysis
