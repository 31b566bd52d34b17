// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/export/contents.h"
#include "analysis/export/export.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// How a row's cell is written.
template <typename Row>
struct ExportCell {
    /// Adds its text; nothing: not known.
    std::function<void(const Row& row, std::string& out)> append;
    bool number;  ///< the text is a number; a yes or no is 1 or 0
};

/// One column of an exported table: its cells and its entry in the data dictionary are made from
/// here and nowhere else.
template <typename Row>
struct ExportColumn {
    std::string name;
    std::string description;
    std::vector<std::pair<std::string, std::string>> levels;  ///< value and meaning; may be empty
    std::string units;                                        ///< empty: has none
    ExportCell<Row> cell;
    bool personal = false;  ///< may tell who it was: not in an anonymous export
};

template <typename Row>
struct ExportTable {
    std::string name;  ///< of the file, without its ending
    std::vector<ExportColumn<Row>> columns;
};

/// A session with its events.
struct SessionRow {
    const SessionRecord* session = nullptr;
    const std::vector<EventRecord>* events = nullptr;  ///< but those that are answers
    const std::vector<EventRecord>* answers = nullptr;
};

/// A trial with the session it belongs to.
struct TrialRow {
    const TrialRecord* trial = nullptr;
    const SessionRecord* session = nullptr;
    std::size_t number = 0;                   ///< of the row in its file, from 1
    const std::string* first_file = nullptr;  ///< image shown first; nullptr: not known
    const std::string* second_file = nullptr;
    const std::string* left_out = nullptr;  ///< ExportOptions::left_out; nullptr: not known
    const ExportedView* view = nullptr;     ///< nullptr: not known
    /// Whether the participant saw none; nothing: that answer was not offered.
    std::optional<bool> no_difference = {};
};

/// A condition as it was shown, with its votes in completed sessions.
struct ConditionRow {
    std::string study;
    Kind kind = Kind::kParticipant;
    TrialRecord shown;  ///< only what belongs to the condition: its name, scene, variants ...
    Votes votes;
};

[[nodiscard]] const ExportTable<ParticipantRecord>& participants_export();
[[nodiscard]] const ExportTable<SessionRow>& sessions_export();
[[nodiscard]] const ExportTable<TrialRow>& trials_export();
[[nodiscard]] const ExportTable<ConditionRow>& conditions_export();
[[nodiscard]] const ExportTable<ExportedTest>& tests_export();

}  // namespace obscura::analysis
