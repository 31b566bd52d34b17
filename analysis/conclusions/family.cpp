// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/family.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/conclusions/published_study.h"
#include "analysis/text/natural_order.h"

namespace obscura::analysis {
namespace {

std::vector<PlannedHypothesis> named_by_conditions(const Tally& tally) {
    std::map<std::string, PlannedHypothesis> by_name;
    for (const ConditionVotes& condition : tally.conditions) {
        if (condition.hypothesis.empty()) continue;
        PlannedHypothesis& hypothesis = by_name[condition.hypothesis];
        hypothesis.id = condition.hypothesis;
        hypothesis.conditions.push_back(condition.id);
    }
    std::vector<PlannedHypothesis> hypotheses;
    for (auto& [name, hypothesis] : by_name) hypotheses.push_back(std::move(hypothesis));
    return hypotheses;
}

/// Whether the answers are to all that the hypotheses take.
bool has_conditions_of(const Tally& tally, const std::vector<PlannedHypothesis>& hypotheses) {
    const auto is_answered = [&](const std::string& id) {
        return std::any_of(tally.conditions.begin(), tally.conditions.end(),
                           [&](const ConditionVotes& condition) { return condition.id == id; });
    };
    return std::all_of(hypotheses.begin(), hypotheses.end(), [&](const PlannedHypothesis& own) {
        return std::all_of(own.conditions.begin(), own.conditions.end(), is_answered);
    });
}

}  // namespace

const PlannedHypothesis* Family::interaction() const {
    const auto found = std::find_if(hypotheses.begin(), hypotheses.end(),
                                    [](const auto& own) { return own.is_interaction; });
    return found == hypotheses.end() ? nullptr : &*found;
}

Family family_of(const Tally& tally) {
    Family family;
    if (tally.plan.has_value() && !tally.plan->hypotheses.empty()) {
        family = {tally.plan->hypotheses, FamilyOrigin::kPlan,
                  "The hypotheses are those that the study fixed before it had data."};
    } else if (is_built_in(tally) && has_conditions_of(tally, published_hypotheses())) {
        family = {published_hypotheses(), FamilyOrigin::kBuiltIn,
                  "The hypotheses are the thesis's, in the family that the built-in study fixes."};
    } else {
        family = {named_by_conditions(tally), FamilyOrigin::kConditions,
                  fmt::format(
                      "The hypotheses are those that the conditions name; that they were "
                      "fixed before there were data is not known ({}).",
                      tally.plan.has_value() ? "the study's plan holds none" : tally.plan.reason)};
    }
    std::stable_sort(family.hypotheses.begin(), family.hypotheses.end(),
                     [](const PlannedHypothesis& one, const PlannedHypothesis& other) {
                         return naturally_before(one.id, other.id);
                     });
    return family;
}

}  // namespace obscura::analysis
