// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/study_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "analysis/text/text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using Json = nlohmann::json;

constexpr const char* kAllowedPlan =
    "is nothing, or a JSON object with hypotheses: objects with id, statement, kind (preference or "
    "interaction), conditions or pairs (of ids), margin (0 to 0.5) and role (primary or "
    "secondary), sides (session or trial), questions: objects with id and kind, ties (split or "
    "davidson), and stopping: an object with looks (rising numbers of "
    "participants, one where nothing is spent) and spending (none, obrien-fleming or pocock)";

/// The text is no plan.
struct NoPlan {};

std::string text_of(const Json& value) {
    if (!value.is_string()) throw NoPlan{};
    return value.get<std::string>();
}

std::vector<std::string> texts_of(const Json& value, std::size_t fewest) {
    if (!value.is_array() || value.size() < fewest) throw NoPlan{};
    std::vector<std::string> texts;
    for (const Json& entry : value) texts.push_back(text_of(entry));
    return texts;
}

std::string one_of(const Json& value, std::string_view one, std::string_view other) {
    std::string text = text_of(value);
    if (text != one && text != other) throw NoPlan{};
    return text;
}

PlannedHypothesis hypothesis_of(const Json& object) {
    if (!object.is_object()) throw NoPlan{};
    PlannedHypothesis hypothesis;
    for (const auto& [name, value] : object.items()) {
        if (name == "id") {
            hypothesis.id = text_of(value);
        } else if (name == "statement") {
            hypothesis.statement = text_of(value);
        } else if (name == "kind") {
            hypothesis.is_interaction = one_of(value, "preference", "interaction") == "interaction";
        } else if (name == "conditions") {
            hypothesis.conditions = texts_of(value, 1);
        } else if (name == "pairs" && value.is_array()) {
            for (const Json& pair : value) hypothesis.pairs.push_back(texts_of(pair, 2));
        } else if (name == "margin" && value.is_number()) {
            hypothesis.margin = value.get<double>();
        } else if (name == "role") {
            hypothesis.is_primary = one_of(value, "primary", "secondary") == "primary";
        } else {
            throw NoPlan{};
        }
    }
    const bool takes_its_own = hypothesis.is_interaction
                                   ? !hypothesis.pairs.empty() && hypothesis.conditions.empty()
                                   : !hypothesis.conditions.empty() && hypothesis.pairs.empty();
    if (hypothesis.id.empty() || !takes_its_own ||
        !(hypothesis.margin > 0.0 && hypothesis.margin < 0.5)) {  // negated by NaN
        throw NoPlan{};
    }
    return hypothesis;
}

/// What is asked of each pair; analysis/questions/answers.h reads it.
void require_question(const Json& object) {
    const bool named = object.is_object() && object.contains("id") && object.contains("kind") &&
                       object["id"].is_string() && object["kind"].is_string();
    if (!named) throw NoPlan{};
}

PlannedLooks looks_of(const Json& object) {
    if (!object.is_object()) throw NoPlan{};
    PlannedLooks looks;
    for (const auto& [name, value] : object.items()) {
        if (name == "spending") {
            const auto spending = spending_from(text_of(value));
            if (!spending) throw NoPlan{};
            looks.spending = *spending;
        } else if (name == "looks" && value.is_array()) {
            for (const Json& look : value) {
                if (!look.is_number_unsigned()) throw NoPlan{};
                looks.looks.push_back(look.get<std::int64_t>());
            }
        } else {
            throw NoPlan{};
        }
    }
    const auto& list = looks.looks;
    const bool rises =
        std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
    const bool is_one = looks.spending == Spending::kNone;
    if (list.empty() || list.front() < 1 || !rises || list.size() > kMostLooks ||
        (is_one && list.size() > 1)) {
        throw NoPlan{};
    }
    return looks;
}

StudyPlan parsed_plan(std::string_view text) {
    StudyPlan plan;
    if (text.empty()) return plan;
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) throw NoPlan{};
    for (const auto& [name, value] : json.items()) {
        if (name == "hypotheses" && value.is_array()) {
            for (const Json& entry : value) plan.hypotheses.push_back(hypothesis_of(entry));
        } else if (name == "stopping") {
            plan.stopping = looks_of(value);
        } else if (name == "sides") {
            plan.has_sides_by_trial = one_of(value, "session", "trial") == "trial";
        } else if (name == "questions" && value.is_array()) {
            for (const Json& entry : value) require_question(entry);
        } else if (name == "ties") {
            (void)one_of(value, "split", "davidson");
        } else {
            throw NoPlan{};
        }
    }
    const auto interactions = std::count_if(plan.hypotheses.begin(), plan.hypotheses.end(),
                                            [](const auto& own) { return own.is_interaction; });
    if (interactions > 1) throw NoPlan{};
    return plan;
}

}  // namespace

std::optional<std::string> study_plan_problem(std::string_view text) {
    try {
        (void)parsed_plan(text);
        return std::nullopt;
    } catch (const NoPlan&) {
        return kAllowedPlan;
    }
}

StudyPlan study_plan(std::string_view text, std::string_view where) {
    try {
        return parsed_plan(text);
    } catch (const NoPlan&) {
        throw base::bad_input("{}: study_plan is '{}', allowed {}", where, printable(text),
                              kAllowedPlan);
    }
}

}  // namespace obscura::analysis
