// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/store/store.h"

namespace obscura::analysis {

/// Everything that an export is made of. Sessions are read before trials, so that every answer of a
/// session that was completed is there, also while a kiosk is writing.
struct StoreContents {
    std::vector<ParticipantRecord> participants;
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;
};

[[nodiscard]] inline StoreContents read_contents(Store& store) {
    return {store.participants(), store.sessions(), store.trials()};
}

}  // namespace obscura::analysis
