// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <soci/soci.h>

#include <string>
#include <vector>

#include "analysis/store/records.h"

namespace obscura::analysis {

enum class CellType { kText, kInteger, kReal };

/// One value on its way into or out of the database; `indicator` says NULL.
struct Cell {
    std::string text;
    long long integer = 0;
    double real = 0.0;
    soci::indicator indicator = soci::i_ok;
};

/// One column of a table and the member of the record that it holds.
template <typename Record>
struct Column {
    const char* name;
    CellType type;
    void (*to_cell)(const Record&, Cell&);
    void (*from_cell)(Record&, const Cell&);
};

/// Every column of a table but `entry`, the number of the row. Insert and select both read it.
template <typename Record>
struct RecordTable {
    const char* name;
    std::vector<Column<Record>> columns;
};

[[nodiscard]] const RecordTable<ParticipantRecord>& participants_table();
[[nodiscard]] const RecordTable<SessionRecord>& sessions_table();
[[nodiscard]] const RecordTable<TrialRecord>& trials_table();
[[nodiscard]] const RecordTable<EventRecord>& events_table();

}  // namespace obscura::analysis
