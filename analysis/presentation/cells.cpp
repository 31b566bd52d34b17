// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/cells.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/presentation/journal.h"

namespace obscura::analysis {

std::string p_cell(const Possible<PValue>& p) { return p.has_value() ? p_number(*p) : kNoValue; }

std::string p_cell(const Possible<double>& p) { return p.has_value() ? p_number(p) : kNoValue; }

std::string cell(const Possible<double>& value, int decimals) {
    return value.has_value() ? fmt::format("{:.{}f}", *value, decimals) : kNoValue;
}

std::vector<const ConditionResult*> by_validity(const Analysis& analysis) {
    std::vector<const ConditionResult*> ordered;
    for (const ConditionResult& result : analysis.conditions) ordered.push_back(&result);
    std::stable_sort(ordered.begin(), ordered.end(), [](const auto* one, const auto* other) {
        return level_number(one->condition.validity) < level_number(other->condition.validity);
    });
    return ordered;
}

std::string label_of(const ConditionVotes& condition) {
    std::string text =
        fmt::format("{}: {} | {}", condition.id, condition.variant_a, condition.variant_b);
    if (!condition.validity.empty()) text += fmt::format(" ({})", condition.validity);
    return text;
}

std::string rule_words(const ExclusionRule& rule) {
    std::vector<std::string> parts;
    if (rule.min_catch_correct) {
        parts.push_back(fmt::format("fewer than {} of the catch trials as expected",
                                    percent(*rule.min_catch_correct)));
    }
    if (rule.min_repeat_agreement) {
        parts.push_back(fmt::format("fewer than {} of repeated pairs answered alike",
                                    percent(*rule.min_repeat_agreement)));
    }
    if (rule.min_response_time_s) {
        parts.push_back(
            fmt::format("a median response time below {:g} s", *rule.min_response_time_s));
    }
    return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", or "));
}

}  // namespace obscura::analysis
