// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/tally.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace obscura::analysis {

Tally tally_trials(const std::string& source, const std::vector<SessionRecord>& sessions,
                   const std::vector<TrialRecord>& trials, const std::string& study, Kind kind) {
    AnswerTable table;
    table.source = source;
    for (const SessionRecord& session : sessions) table.add(session);
    for (const TrialRecord& trial : trials) table.add(trial);
    return tally_of(table, study, kind);
}

Tally without(const Tally& tally, const std::vector<bool>& left_out) {
    Tally kept;
    kept.source = tally.source;
    kept.study = tally.study;
    kept.kind = tally.kind;
    kept.participants = tally.participants;
    kept.exclusion = tally.exclusion;
    kept.plan = tally.plan;
    kept.looks_before = tally.looks_before;
    kept.asks_validity = tally.asks_validity;
    kept.n_participants = std::count(left_out.begin(), left_out.end(), false);
    OrderVotes order;
    for (const ConditionVotes& condition : tally.conditions) {
        ConditionVotes& entry = kept.conditions.emplace_back(ConditionVotes{condition.id,
                                                                            condition.hypothesis,
                                                                            condition.validity,
                                                                            condition.variant_a,
                                                                            condition.variant_b,
                                                                            {},
                                                                            condition.view});
        for (const Answer& answer : condition.answers) {
            if (left_out[static_cast<std::size_t>(answer.participant)]) continue;
            entry.answers.push_back(answer);
            ++(answer.chose_b ? entry.votes.b : entry.votes.a);
            ++order.n;
            if (answer.chose_b == answer.b_second) ++order.second_chosen;
        }
    }
    kept.order = tally.order.has_value() ? Possible<OrderVotes>(order) : tally.order;
    return kept;
}

void name_views(Tally& tally, const std::map<std::string, std::string>& views) {
    for (ConditionVotes& condition : tally.conditions) {
        if (const auto view = views.find(condition.view); view != views.end()) {
            condition.view = view->second;
        }
    }
}

}  // namespace obscura::analysis
