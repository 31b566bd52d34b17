// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

namespace obscura::analysis {

/// What merging brought; sessions that were there already are counted apart.
struct MergedRows {
    int sessions = 0;
    int sessions_there = 0;
    int trials = 0;
    int events = 0;
    /// Sessions whose row of the order another one has too: each kiosk counted for itself.
    int shared_slots = 0;
};

}  // namespace obscura::analysis
