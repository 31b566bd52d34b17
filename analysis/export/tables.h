// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/export/contents.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// One column of an exported table: its cells and its entry in the data dictionary are made from
/// here and nowhere else.
template <typename Row>
struct ExportColumn {
    std::string name;
    std::string description;
    std::vector<std::pair<std::string, std::string>> levels;  ///< value and meaning; may be empty
    std::string units;                                        ///< empty: has none
    std::string (*cell)(const Row&);                          ///< empty text: not known
};

template <typename Row>
struct ExportTable {
    std::string file;
    std::vector<ExportColumn<Row>> columns;
};

/// A trial with the session it belongs to.
struct TrialRow {
    const TrialRecord* trial = nullptr;
    const SessionRecord* session = nullptr;
};

/// A condition as it was shown, with its votes in completed sessions.
struct ConditionRow {
    std::string study;
    Kind kind = Kind::kParticipant;
    TrialRecord shown;  ///< only what belongs to the condition: its name, scene, variants ...
    Votes votes;
};

[[nodiscard]] const ExportTable<ParticipantRecord>& participants_export();
[[nodiscard]] const ExportTable<SessionRecord>& sessions_export();
[[nodiscard]] const ExportTable<TrialRow>& trials_export();
[[nodiscard]] const ExportTable<ConditionRow>& conditions_export();

/// Every trial with its session, in the store's order. The rows point into `contents`.
[[nodiscard]] std::vector<TrialRow> trial_rows(const StoreContents& contents);

/// Every condition that was shown, one row for each study, kind and way it was described, in order
/// of the first showing.
[[nodiscard]] std::vector<ConditionRow> condition_rows(const StoreContents& contents);

}  // namespace obscura::analysis
