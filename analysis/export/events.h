// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/export/tables.h"

namespace obscura::analysis {

/// An event with the session it belongs to.
struct EventRow {
    const EventRecord* event = nullptr;
    const SessionRecord* session = nullptr;  ///< nullptr: of no session
};

[[nodiscard]] const ExportTable<EventRow>& events_export();

/// The same as BIDS asks for it: first onset and duration.
[[nodiscard]] ExportTable<EventRow> bids_events_export();

/// Columns of the table of sessions that count the session's events, one for each kind that may
/// have disturbed it.
[[nodiscard]] std::vector<ExportColumn<SessionRow>> event_count_columns();

}  // namespace obscura::analysis
