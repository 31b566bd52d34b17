// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::analysis {

/// What a withdrawal erased.
struct WithdrawnRows {
    int sessions = 0;
    int trials = 0;
    int events = 0;
};

/// Erases a participant from the store of that URL: form, sessions, answers and events, in one
/// transaction, with an event that one was withdrawn, which names neither the participant nor the
/// session. The places in the order are free again. On PostgreSQL the role needs DELETE on the four
/// tables. Throws failure where there is no such participant, or one of its sessions is open.
WithdrawnRows withdraw_participant(const std::string& store_url, const std::string& participant_id,
                                   const std::string& utc);

}  // namespace obscura::analysis
