// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/store/database.h"
#include "analysis/store/merged_rows.h"
#include "analysis/store/records.h"

namespace obscura::analysis {

/// All rows of a store, in their order.
struct StoreRows {
    std::string name;  ///< of the store, for messages
    std::vector<ParticipantRecord> participants;
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;
    std::vector<EventRecord> events;
};

/// Adds the rows that `into` has not yet, within the transaction that is open: a second time adds
/// nothing. A session that is there goes on with what `from` has of it more. Throws bad input,
/// before anything is written, where a row there says something else under the same name, or where
/// the study or its images are not the same in both.
MergedRows merge(Database& into, const StoreRows& from);

}  // namespace obscura::analysis
