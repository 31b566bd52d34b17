// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/answers.h"

#include <cmath>

namespace obscura::analysis {

std::size_t ConditionHash::operator()(const ConditionEntry& condition) const {
    // Knuth's multiplicative hashing (1973, section 6.4), one factor a text.
    std::uint64_t hash = condition.id;
    for (const std::uint32_t part : {condition.hypothesis, condition.validity, condition.variant_a,
                                     condition.variant_b, condition.scene, condition.study_a}) {
        hash = (hash ^ part) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

std::uint32_t AnswerTable::place_of(const ConditionEntry& condition) {
    const auto number = static_cast<std::uint32_t>(conditions.size());
    const auto [place, is_new] = condition_places_.emplace(condition, number);
    if (is_new) conditions.push_back(condition);
    return place->second;
}

void AnswerTable::rename(const std::unordered_map<std::uint32_t, std::uint32_t>& ids) {
    for (ConditionEntry& condition : conditions) {
        if (const auto id = ids.find(condition.id); id != ids.end()) condition.id = id->second;
    }
    condition_places_.clear();
}

void AnswerTable::add(const SessionRecord& session) {
    const std::uint32_t name = names.number_of(session.session_id);
    session_places_.emplace(name, static_cast<std::uint32_t>(sessions.size()));
    sessions.push_back({name, names.number_of(session.participant_id),
                        names.number_of(session.study), names.number_of(session.exclusion),
                        session.kind, session.state, names.number_of(session.study_sha256),
                        names.number_of(session.study_plan)});
}

void AnswerTable::add(const TrialRecord& trial) {
    // Most trials are of the session of the one before.
    if (names[last_session_] != trial.session_id) last_session_ = names.number_of(trial.session_id);
    const auto session = session_places_.find(last_session_);
    if (session == session_places_.end()) return;
    AnswerEntry answer;
    answer.session = session->second;
    ConditionEntry shown;
    shown.id = names.number_of(trial.condition);
    shown.hypothesis = names.number_of(trial.hypothesis);
    shown.validity = names.number_of(trial.validity);
    shown.variant_a = names.number_of(trial.condition_A);
    shown.variant_b = names.number_of(trial.condition_B);
    shown.scene = names.number_of(trial.scene);
    shown.study_a = shown.variant_a;
    answer.condition = place_of(shown);
    answer.repeats = names.number_of(trial.repeats);
    answer.trial_index = trial.trial_index;
    if (std::isfinite(trial.response_time_s)) answer.response_time_s = trial.response_time_s;
    answer.kind = trial.kind;
    answer.a_selected = trial.is_A_selected;
    answer.first_shown = trial.first_shown;
    answer.expected = trial.expected;
    answers.push_back(answer);
}

}  // namespace obscura::analysis
