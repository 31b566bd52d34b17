// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/store/store.h"

namespace obscura::analysis {

/// Everything in the store at one moment, also while a kiosk is writing.
struct StoreContents {
    std::vector<ParticipantRecord> participants;
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;
};

[[nodiscard]] inline StoreContents read_contents(Store& store) {
    StoreContents contents;
    store.of_one_moment([&] {
        contents = {store.participants(), store.sessions(), store.trials()};
    });
    return contents;
}

}  // namespace obscura::analysis
