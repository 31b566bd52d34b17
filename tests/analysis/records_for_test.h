// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

#include "analysis/store/store.h"

namespace obscura::tests {

inline constexpr const char* kUtc = "2026-05-01T12:00:00Z";

inline analysis::ParticipantRecord a_participant(int number) {
    analysis::ParticipantRecord participant;
    participant.participant_id = fmt::format("p{}", number);
    participant.age_years = 31;
    participant.gender = "female";
    participant.normal_vision = true;
    participant.naive = true;
    participant.consent = true;
    participant.created_utc = kUtc;
    return participant;
}

/// Session s<number> of participant p<number>, in the slot of that number, with seven conditions.
inline analysis::SessionRecord a_session(int number) {
    analysis::SessionRecord session;
    session.session_id = fmt::format("s{}", number);
    session.participant_id = fmt::format("p{}", number);
    session.study = "jakobsen2010";
    session.study_sha256 = std::string(64, 'a');
    session.order = "latin-square";
    session.seed = 20100501;
    session.slot = static_cast<std::uint64_t>(number);
    session.latin_square = static_cast<std::uint64_t>(number) / 14;
    session.latin_row = number % 7;
    session.swapped = number / 7 % 2 == 1;
    session.condition_count = 7;
    session.started_utc = kUtc;
    session.software = "Obscura 0.1.0";
    session.operating_system = "Debian GNU/Linux 12";
    session.gpu_renderer = "llvmpipe";
    session.display = "none";
    session.refresh_hz = 60.0;
    return session;
}

/// Trial `index` of session s<number>; B was chosen.
inline analysis::TrialRecord a_trial(int number, int index) {
    analysis::TrialRecord trial;
    trial.session_id = fmt::format("s{}", number);
    trial.trial_index = index;
    trial.condition = fmt::format("C{}", index);
    trial.hypothesis = "H1";
    trial.scene = "atrium";
    trial.validity = "high";
    trial.condition_A = "None";
    trial.condition_B = "Blizzard24";
    trial.response_time_s = 1.25;
    trial.first_onset_s = 10.0;
    trial.second_onset_s = 15.0;
    trial.question_onset_s = 18.0;
    trial.first_view_ms = 3000.0;
    trial.second_view_ms = 3000.0;
    trial.grey_ms_measured = 2000.1;
    trial.first_sha256 = std::string(64, 'b');
    trial.second_sha256 = std::string(64, 'c');
    trial.answered_utc = kUtc;
    return trial;
}

/// A whole session with its trials, completed.
inline void add_completed(analysis::Store& store, int number,
                          analysis::Kind kind = analysis::Kind::kParticipant) {
    auto participant = a_participant(number);
    auto session = a_session(number);
    participant.kind = session.kind = kind;
    store.begin_session(participant, session);
    for (int index = 0; index < session.condition_count; ++index) {
        auto trial = a_trial(number, index);
        trial.kind = kind;
        store.add_trial(trial);
    }
    store.complete_session(session.session_id, kUtc);
}

}  // namespace obscura::tests
