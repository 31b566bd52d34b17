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
    if (session_places_.size() <= name) session_places_.resize(name + 1, kNowhere);
    if (session_places_[name] == kNowhere) {
        session_places_[name] = static_cast<std::uint32_t>(sessions.size());
    }
    // Most sessions share all but their names with the one before.
    const SessionEntry last = sessions.empty() ? SessionEntry() : sessions.back();
    sessions.push_back({name, names.number_of(session.participant_id),
                        names.number_of(session.study, last.study),
                        names.number_of(session.exclusion, last.exclusion), session.kind,
                        session.state, names.number_of(session.study_sha256, last.study_sha256),
                        names.number_of(session.study_plan, last.study_plan)});
}

/// The place of what the trial showed. Most trials show what their condition showed before.
std::uint32_t AnswerTable::place_of(const TrialRecord& trial) {
    const std::uint32_t id = names.number_of(trial.condition);
    const auto [last, is_new] = last_places_.try_emplace(id);
    const ConditionEntry before = is_new ? ConditionEntry() : conditions[last->second];
    ConditionEntry shown;
    shown.id = id;
    shown.hypothesis = names.number_of(trial.hypothesis, before.hypothesis);
    shown.validity = names.number_of(trial.validity, before.validity);
    shown.variant_a = names.number_of(trial.condition_A, before.variant_a);
    shown.variant_b = names.number_of(trial.condition_B, before.variant_b);
    shown.scene = names.number_of(trial.scene, before.scene);
    shown.study_a = shown.variant_a;
    if (is_new || shown != before) last->second = place_of(shown);
    return last->second;
}

void AnswerTable::add(const TrialRecord& trial) {
    // Most trials are of the session of the one before.
    last_session_ = names.number_of(trial.session_id, last_session_);
    const bool is_known =
        last_session_ < session_places_.size() && session_places_[last_session_] != kNowhere;
    if (!is_known) return;
    AnswerEntry answer;
    answer.session = session_places_[last_session_];
    answer.condition = place_of(trial);
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
