// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "analysis/direction.h"
#include "analysis/table/values.h"

namespace obscura::analysis {
namespace {

/// Whichever variant is called A; one condition may be shown in several scenes.
bool is_same_thing(const ConditionEntry& one, const ConditionEntry& other) {
    return one.hypothesis == other.hypothesis && one.validity == other.validity &&
           std::minmax(one.variant_a, one.variant_b) ==
               std::minmax(other.variant_a, other.variant_b);
}

}  // namespace

void ConditionReader::read(const CsvRow& row, AnswerEntry& answer) {
    const std::string validity = lower(fields_.field(row, kValidity));
    const bool is_level = validity == "low" || validity == "moderate" || validity == "high";
    if (!is_level && !is_missing(validity)) {
        fields_.report(row, kValidity, fields_.field(row, kValidity),
                       "are low, moderate, high; --map validity= passes the column over");
    }
    ConditionEntry shown;
    shown.variant_a = fields_.needed(row, kConditionA);
    shown.variant_b = fields_.needed(row, kConditionB);
    shown.hypothesis = fields_.number_of(row, kHypothesis);
    shown.validity = is_level ? table_.names.number_of(validity) : 0;
    shown.scene = fields_.number_of(row, kScene);
    shown.study_a = fields_.number_of(row, kStudyA);
    if (shown.study_a != 0 && shown.study_a != shown.variant_a &&
        shown.study_a != shown.variant_b) {
        fields_.report(row, kStudyA, fields_.field(row, kStudyA),
                       "is one of the row's two variants");
    }
    if (columns_.has(kCondition)) {
        shown.id = fields_.needed(row, kCondition);
    } else if (!name_condition(row, shown)) {
        return;
    }
    answer.condition = table_.place_of(shown);
    check_description(row, answer);
}

bool ConditionReader::name_condition(const CsvRow& row, ConditionEntry& shown) {
    if (shown.variant_a == shown.variant_b) {
        fields_.report(row, kConditionB, fields_.field(row, kConditionB),
                       "is another variant than condition_A");
        return false;
    }
    ConditionEntry pair;
    pair.scene = shown.scene;
    pair.validity = shown.validity;
    std::tie(pair.variant_a, pair.variant_b) = std::minmax(shown.variant_a, shown.variant_b);
    const auto [named, is_new] = named_.emplace(pair, 0);
    if (is_new) {
        const std::string& level = table_.names[pair.validity];
        named->second = table_.names.number_of(
            level.empty() ? pair_name(pair) : fmt::format("{} ({})", pair_name(pair), level));
    }
    shown.id = named->second;
    return true;
}

std::string ConditionReader::pair_name(const ConditionEntry& pair) const {
    const std::string* a = &table_.names[pair.variant_a];
    const std::string* b = &table_.names[pair.variant_b];
    if (is_a_of(*b, *a)) std::swap(a, b);
    const std::string& scene = table_.names[pair.scene];
    return fmt::format("{}{}{} - {}", scene, scene.empty() ? "" : ": ", *a, *b);
}

void ConditionReader::shorten_names() {
    std::map<std::string, std::vector<std::uint32_t>> levels;
    for (const auto& [pair, id] : named_) levels[pair_name(pair)].push_back(id);
    std::unordered_map<std::uint32_t, std::uint32_t> shorter;
    for (const auto& [name, ids] : levels) {
        if (ids.size() == 1) shorter.emplace(ids.front(), table_.names.number_of(name));
    }
    table_.rename(shorter);
}

void ConditionReader::check_description(const CsvRow& row, const AnswerEntry& answer) {
    const SessionEntry& session = table_.sessions[answer.session];
    if (session.state != SessionState::kCompleted || answer.kind != session.kind) return;
    ConditionEntry key;
    key.id = table_.conditions[answer.condition].id;
    key.hypothesis = session.study;
    key.validity = static_cast<std::uint32_t>(answer.kind);
    const auto [first, is_new] = described_.emplace(key, std::pair(answer.condition, row.line));
    if (first->second.first == answer.condition ||
        is_same_thing(table_.conditions[first->second.first],
                      table_.conditions[answer.condition])) {
        return;
    }
    problems_.add(row.line, fmt::format("condition '{}' is {}, allowed is what line {} says: {}",
                                        table_.names[key.id], description_of(answer.condition),
                                        first->second.second, description_of(first->second.first)));
}

std::string ConditionReader::description_of(std::uint32_t condition) const {
    const ConditionEntry& shown = table_.conditions[condition];
    const Names& names = table_.names;
    return fmt::format("{} against {} (validity '{}', hypothesis '{}')", names[shown.variant_a],
                       names[shown.variant_b], names[shown.validity], names[shown.hypothesis]);
}

}  // namespace obscura::analysis
