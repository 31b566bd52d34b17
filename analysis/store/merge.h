// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/store/database.h"
#include "analysis/store/records.h"

namespace obscura::analysis {

/// All rows of a store, in their order.
struct StoreContents {
    std::string name;  ///< of the store, for messages
    std::vector<ParticipantRecord> participants;
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;
    std::vector<EventRecord> events;
};

/// What merging brought; sessions that were there already are counted apart.
struct MergedRows {
    int sessions = 0;
    int sessions_there = 0;
    int trials = 0;
    int events = 0;
    /// Sessions whose row of the order another one has too: each kiosk counted for itself.
    int shared_slots = 0;
};

/// Adds the rows that `into` has not yet, within the transaction that is open: a second time adds
/// nothing. A session that is there goes on with what `from` has of it more. Throws bad input,
/// before anything is written, where a row there says something else under the same name, or where
/// the study or its images are not the same in both.
MergedRows merge(Database& into, const StoreContents& from);

/// The event's name under which a session keeps the hash over the study's images.
inline constexpr const char* kStimuliDigestEvent = "stimuli digest";

}  // namespace obscura::analysis
