// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/tally.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <tuple>
#include <unordered_map>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

/// C2 before C10: runs of digits compare by length, then by digits.
bool naturally_before(std::string_view one, std::string_view other) {
    const auto is_digit = [](char letter) {
        return std::isdigit(static_cast<unsigned char>(letter)) != 0;
    };
    const auto take_run = [&](std::string_view& text) {
        const bool digits = is_digit(text.front());
        std::size_t length = 1;
        while (digits && length < text.size() && is_digit(text[length])) ++length;
        const std::string_view run = text.substr(0, length);
        text.remove_prefix(length);
        return run;
    };
    while (!one.empty() && !other.empty()) {
        const std::string_view a = take_run(one);
        const std::string_view b = take_run(other);
        if (a == b) continue;
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    }
    return one.size() < other.size();
}

/// How many completed sessions of the kind there are.
std::ptrdiff_t completed(const std::vector<SessionRecord>& sessions, Kind kind) {
    return std::count_if(sessions.begin(), sessions.end(), [&](const SessionRecord& session) {
        return session.state == SessionState::kCompleted && session.kind == kind;
    });
}

base::Error no_sessions(const std::string& source, const std::vector<SessionRecord>& sessions,
                        Kind kind) {
    const Kind other = kind == Kind::kParticipant ? Kind::kSimulated : Kind::kParticipant;
    const auto others = completed(sessions, other);
    if (others > 0) {
        return base::bad_input(
            "{} has no completed session of kind {}, but {} of kind {}: --kind {} analyses those",
            source, to_string(kind), others, to_string(other), to_string(other));
    }
    return base::bad_input("{} has no completed session ({} in all): there is nothing to analyse",
                           source, sessions.size());
}

/// The one study to analyse.
std::string chosen_study(const std::string& source, const std::vector<SessionRecord>& sessions,
                         const std::string& study, Kind kind) {
    std::set<std::string> studies;
    for (const SessionRecord& session : sessions) {
        if (session.state == SessionState::kCompleted && session.kind == kind) {
            studies.insert(session.study);
        }
    }
    if (studies.empty()) throw no_sessions(source, sessions, kind);
    if (study.empty() && studies.size() == 1) return *studies.begin();
    if (study.empty()) {
        throw base::bad_input("{} has several studies, --study must name one of: {}", source,
                              fmt::join(studies, ", "));
    }
    if (!studies.contains(study)) {
        throw base::bad_input("--study {}: {} has no completed session of it, allowed are: {}",
                              study, source, fmt::join(studies, ", "));
    }
    return study;
}

/// Where each condition stands in the list of them.
using Places = std::unordered_map<std::string, std::size_t>;

/// The entry of the trial's condition, made when it is new.
ConditionVotes& entry_of(const std::string& source, const TrialRecord& trial, Places& places,
                         std::vector<ConditionVotes>& conditions) {
    const auto [place, is_new] = places.emplace(trial.condition, conditions.size());
    if (is_new) {
        return conditions.emplace_back(ConditionVotes{trial.condition,
                                                      trial.hypothesis,
                                                      trial.validity,
                                                      trial.condition_A,
                                                      trial.condition_B,
                                                      {}});
    }
    ConditionVotes* const found = &conditions[place->second];
    const auto met =
        std::tie(trial.hypothesis, trial.validity, trial.condition_A, trial.condition_B);
    const auto first =
        std::tie(found->hypothesis, found->validity, found->variant_a, found->variant_b);
    if (met != first) {
        throw base::bad_input(
            "{}: condition {} is {} against {} ({}, {}) in session {}, but {} against {} ({}, {}) "
            "in an earlier one: answers to different studies cannot be added up",
            source, trial.condition, trial.condition_A, trial.condition_B, trial.validity,
            trial.hypothesis, trial.session_id, found->variant_a, found->variant_b, found->validity,
            found->hypothesis);
    }
    return *found;
}

}  // namespace

Tally tally_trials(const std::string& source, const std::vector<SessionRecord>& sessions,
                   const std::vector<TrialRecord>& trials, const std::string& study, Kind kind) {
    Tally tally;
    tally.source = source;
    tally.kind = kind;
    tally.study = chosen_study(source, sessions, study, kind);
    std::unordered_map<std::string, std::int32_t> participant_of;  // a session that counts
    std::unordered_map<std::string, std::int32_t> participants;
    for (const SessionRecord& session : sessions) {
        if (session.state != SessionState::kCompleted || session.kind != kind ||
            session.study != tally.study) {
            continue;
        }
        const auto number = static_cast<std::int32_t>(participants.size());
        const auto [participant, is_new] = participants.emplace(session.participant_id, number);
        participant_of.emplace(session.session_id, participant->second);
    }
    OrderVotes order;
    Places places;
    for (const TrialRecord& trial : trials) {
        const auto session = participant_of.find(trial.session_id);
        if (trial.kind != kind || session == participant_of.end() || !trial.repeats.empty())
            continue;
        ConditionVotes& condition = entry_of(source, trial, places, tally.conditions);
        ++(trial.is_A_selected ? condition.votes.a : condition.votes.b);
        condition.answers.push_back(
            {session->second, !trial.is_A_selected, trial.first_shown == 'A'});
        ++order.n;
        if (!trial.response_first) ++order.second_chosen;
    }
    std::stable_sort(tally.conditions.begin(), tally.conditions.end(),
                     [](const ConditionVotes& one, const ConditionVotes& other) {
                         return naturally_before(one.id, other.id);
                     });
    tally.n_participants = static_cast<std::int64_t>(participants.size());
    tally.order = order;
    return tally;
}

}  // namespace obscura::analysis
