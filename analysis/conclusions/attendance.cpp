// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/attendance.h"

namespace obscura::analysis {

Attendance attendance_of(Store& store, const std::string& study, Kind kind) {
    Attendance attendance;
    std::set<std::string> ids;
    store.of_one_moment([&] {
        store.each_session([&](const SessionRecord& session) {
            if (session.study != study || session.kind != kind) return;
            ++attendance.sessions[session.state];
            if (session.state != SessionState::kCompleted) return;
            ids.insert(session.participant_id);
            ++attendance.displays[session.display];
            if (session.refresh_hz <= 0.0) ++attendance.unknown_refresh;
        });
        for (ParticipantRecord& participant : store.participants()) {
            if (!ids.contains(participant.participant_id)) continue;
            attendance.completed.push_back(std::move(participant));
        }
        store.each_trial([&](const TrialRecord& trial, const SessionRecord& session) {
            if (session.study != study || session.state != SessionState::kCompleted ||
                trial.kind != kind || !trial.repeats.empty()) {
                return;
            }
            const char second = trial.first_shown == 'A' ? 'B' : 'A';
            attendance.shown_sha256[{trial.condition, trial.first_shown}].insert(
                trial.first_sha256);
            attendance.shown_sha256[{trial.condition, second}].insert(trial.second_sha256);
        });
    });
    return attendance;
}

}  // namespace obscura::analysis
