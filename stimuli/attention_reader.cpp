// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/attention_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace obscura::stimuli {
namespace {

using Need = TableReader::Need;

constexpr double kLongestResponse_s = 3600.0;

/// Why the condition cannot be the one that is repeated; empty when it can.
std::string obstacle(const Condition& original, const Condition& repeat) {
    if (original.id == repeat.id) return "is the condition itself";
    if (original.practice) return "is practice";
    if (original.expected != '\0') return "is an attention check (catch)";
    if (!original.repeats.empty()) {
        return fmt::format("repeats {} itself", in_quotes(original.repeats));
    }
    return "";
}

std::optional<double> read_bound(TableReader& reader, const std::string& key, double high) {
    const std::optional<double> value = reader.number(key, Need::kOptional);
    if (value && !(*value >= 0.0 && *value <= high)) {
        reader.add(key, fmt::format("{} is out of range, allowed is 0 to {}", *value, high));
        return std::nullopt;
    }
    return value;
}

template <typename Is>
bool any_condition(const Study& study, const Is& is) {
    return std::any_of(study.conditions.begin(), study.conditions.end(), is);
}

/// Whether a condition that counts has the key, or one that was meant to be it; true of no
/// conditions at all, of which something else is said.
bool any_has(const std::vector<const toml::table*>& conditions, const std::string& key) {
    return conditions.empty() ||
           std::any_of(conditions.begin(), conditions.end(), [&](const toml::table* table) {
               std::vector<StudyProblem> ignored;
               const TableReader reader(*table, "", ignored);
               return !(*table)["practice"].value_or(false) &&
                      (reader.has(key) || reader.is_misspelt(key));
           });
}

}  // namespace

char read_expected(TableReader& reader) {
    const toml::node* const given = reader.table().get("catch");
    if (given != nullptr && !given->is_string()) {
        reader.allow("catch");
        reader.add(
            "catch",
            "is no text, allowed are \"a\", \"b\": the side that an attentive observer picks");
        return '\0';
    }
    const auto side = reader.text("catch", Need::kOptional);
    if (!side) return '\0';
    if (*side == "a") return 'A';
    if (*side == "b") return 'B';
    reader.add("catch", fmt::format("{} is no side, allowed are a, b: the one that an attentive "
                                    "observer picks",
                                    in_quotes(*side)));
    return '\0';
}

bool read_identical(TableReader& reader, const Condition& condition) {
    if (!reader.boolean("identical", Need::kOptional).value_or(false)) return false;
    if (condition.expected != '\0') {
        reader.add("identical",
                   "is true beside catch: of two images that are alike an attentive "
                   "observer picks neither");
    }
    if (!condition.hypothesis.empty()) {
        reader.add("identical", fmt::format("is true beside the hypothesis {}: two images that are "
                                            "alike are no vote on it",
                                            in_quotes(condition.hypothesis)));
    }
    return true;
}

void check_practice(TableReader& reader, const Condition& condition) {
    if (!condition.practice) return;
    if (!condition.hypothesis.empty()) {
        reader.add("hypothesis", "is not allowed beside practice, whose answers do not count");
    }
    if (condition.identical) {
        reader.add("identical", "is not allowed beside practice, whose answers do not count");
    }
}

void read_repeats(TableReader& reader, Condition& condition) {
    condition.repeats = reader.text("repeats", Need::kRequired).value_or("");
    for (const char* key : {"scene", "hypothesis", "a", "b", "catch", "identical", "practice"}) {
        if (!reader.has(key)) continue;
        reader.allow(key);
        reader.add(key, "is not allowed beside repeats, which takes it from the other condition");
    }
    condition.expected = '\0';
    condition.practice = false;
    reader.finish();
}

void resolve_repeats(Study& study, const std::vector<const toml::table*>& tables,
                     std::vector<StudyProblem>& problems) {
    std::vector<std::string> repeatable;
    for (const Condition& condition : study.conditions) {
        if (condition.repeats.empty() && condition.expected == '\0' && !condition.practice &&
            !condition.id.empty()) {
            repeatable.push_back(condition.id);
        }
    }
    for (std::size_t i = 0; i < study.conditions.size(); ++i) {
        Condition& repeat = study.conditions[i];
        if (!tables[i]->contains("repeats")) continue;
        const std::string where = fmt::format("condition {}", in_quotes(repeat.id));
        TableReader reader(*tables[i], where, problems);
        const Condition* original = study.find_condition(repeat.repeats);
        if (original == nullptr &&
            any_condition(study, [](const auto& c) { return c.id.empty(); })) {
            continue;  // it may be the one whose id is wrong
        }
        if (original == nullptr) {
            reader.add("repeats", fmt::format("{} is no condition, allowed are {}{}",
                                              in_quotes(repeat.repeats), listed(repeatable),
                                              did_you_mean(repeat.repeats, repeatable)));
        } else if (const std::string why = obstacle(*original, repeat); !why.empty()) {
            reader.add("repeats", fmt::format("{} {}, allowed are {}", in_quotes(repeat.repeats),
                                              why, listed(repeatable)));
        } else {
            repeat.scene = original->scene;
            repeat.hypothesis = original->hypothesis;
            repeat.a = original->a;
            repeat.b = original->b;
            repeat.identical = original->identical;
        }
    }
    if (!study.conditions.empty() && repeatable.empty() &&
        any_condition(study, [](const auto& c) { return c.expected != '\0' && !c.practice; })) {
        problems.push_back({line_of(*tables.front()),
                            "every condition is an attention check (catch) or a repeat, needed is "
                            "one to vote on"});
    }
}

void read_exclusion(const toml::table& table, const std::vector<const toml::table*>& conditions,
                    Study& study, std::vector<StudyProblem>& problems) {
    TableReader reader(table, "exclusion", problems);
    ExclusionRule& rule = study.exclusion;
    rule.min_catch_correct = read_bound(reader, "min_catch_correct", 1.0);
    rule.min_repeat_agreement = read_bound(reader, "min_repeat_agreement", 1.0);
    rule.min_response_time_s = read_bound(reader, "min_response_time_s", kLongestResponse_s);
    if (rule.min_catch_correct && !any_has(conditions, "catch")) {
        reader.add("min_catch_correct", "no condition has the key catch: nothing can be judged");
    }
    if (rule.min_repeat_agreement && !any_has(conditions, "repeats")) {
        reader.add("min_repeat_agreement",
                   "no condition has the key repeats: nothing can be judged");
    }
    reader.finish();
}

}  // namespace obscura::stimuli
