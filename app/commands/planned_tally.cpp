// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/planned_tally.h"

#include <algorithm>

#include "analysis/conclusions/pooling.h"
#include "analysis/text/natural_order.h"
#include "stimuli/variant_names.h"
#include "stimuli/view_names.h"

namespace obscura::app {
namespace {

std::vector<const analysis::ConditionVotes*> conditions_in(
    const analysis::Tally& tally, const std::vector<std::string>& conditions) {
    std::vector<const analysis::ConditionVotes*> own;
    for (const analysis::ConditionVotes& condition : tally.conditions) {
        if (std::find(conditions.begin(), conditions.end(), condition.id) != conditions.end()) {
            own.push_back(&condition);
        }
    }
    return own;
}

}  // namespace

analysis::Tally planned_tally(const stimuli::Study& study) {
    analysis::Tally tally;
    tally.source = study.name;
    tally.study = study.name;
    const stimuli::VariantNames names = stimuli::variant_names(study);
    for (const stimuli::Condition& condition : study.conditions) {
        if (condition.practice || condition.expected != '\0' || !condition.repeats.empty())
            continue;
        analysis::ConditionVotes& votes = tally.conditions.emplace_back();
        votes.id = condition.id;
        votes.hypothesis = condition.hypothesis;
        votes.validity = std::string(to_string(study.scene_of(condition).validity));
        votes.variant_a = names.at({condition.id, 'a'});
        votes.variant_b = names.at({condition.id, 'b'});
        votes.view = condition.scene;
    }
    std::stable_sort(tally.conditions.begin(), tally.conditions.end(),
                     [](const auto& one, const auto& other) {
                         return analysis::naturally_before(one.id, other.id);
                     });
    tally.plan = analysis::study_plan(study.plan_json(), study.name);
    analysis::name_views(tally, stimuli::view_names(study));
    return tally;
}

analysis::Possible<analysis::Pooling> pooling_of(const analysis::Tally& tally,
                                                 const std::vector<std::string>& conditions) {
    const auto own = conditions_in(tally, conditions);
    if (own.empty()) return analysis::Possible<analysis::Pooling>::none("no conditions");
    return analysis::pooling_of(own);
}

std::vector<std::string> turned_in(const analysis::Tally& tally,
                                   const std::vector<std::string>& conditions) {
    const auto own = conditions_in(tally, conditions);
    std::vector<std::string> turned;
    if (own.empty()) return turned;
    const auto pooling = analysis::pooling_of(own);
    for (std::size_t i = 0; pooling.has_value() && i < own.size(); ++i) {
        if (pooling->turned[i]) turned.push_back(own[i]->id);
    }
    return turned;
}

}  // namespace obscura::app
