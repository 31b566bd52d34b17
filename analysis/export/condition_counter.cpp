// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/condition_counter.h"

#include <tuple>

namespace obscura::analysis {

void ConditionCounter::add(const TrialRecord& trial, const SessionRecord& session) {
    ConditionRow& row = entry_of(trial, session);
    if (session.state != SessionState::kCompleted) return;
    ++(trial.is_A_selected ? row.votes.a : row.votes.b);
}

ConditionRow& ConditionCounter::entry_of(const TrialRecord& trial, const SessionRecord& session) {
    const auto described = [](const TrialRecord& shown) {
        return std::tie(shown.hypothesis, shown.scene, shown.validity, shown.condition_A,
                        shown.condition_B, shown.expected, shown.repeats);
    };
    std::vector<std::size_t>& places = places_[trial.condition];
    for (const std::size_t place : places) {
        ConditionRow& row = rows_[place];
        if (row.kind == trial.kind && row.study == session.study &&
            described(row.shown) == described(trial)) {
            return row;
        }
    }
    places.push_back(rows_.size());
    return rows_.emplace_back(ConditionRow{session.study, trial.kind, trial, {}});
}

}  // namespace obscura::analysis
