// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/store/store.h"

namespace obscura::analysis {

/// Who took part in one study, and which files were shown.
struct Attendance {
    std::map<SessionState, int> sessions;          ///< how many of each state
    std::vector<ParticipantRecord> completed;      ///< who completed a session, each once
    std::map<std::string, std::int64_t> displays;  ///< completed sessions on each, by its name
    std::int64_t unknown_refresh = 0;  ///< completed sessions whose refresh rate is not known
    /// SHA-256 of every file shown in votes, by condition and side (A or B).
    std::map<std::pair<std::string, char>, std::set<std::string>> shown_sha256;
};

/// Of the sessions of that study and kind.
[[nodiscard]] Attendance attendance_of(Store& store, const std::string& study, Kind kind);

}  // namespace obscura::analysis
