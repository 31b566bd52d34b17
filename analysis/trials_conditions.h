// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

#include "analysis/answers.h"
#include "analysis/trials_fields.h"

namespace obscura::analysis {

/// Tells what a row of trials showed, and holds every row of a condition against the first one.
/// What it is made from must outlive it.
class ConditionReader {
  public:
    ConditionReader(AnswerTable& table, const TrialsColumns& columns, FileProblems& problems,
                    TrialFields& fields)
        : table_(table), columns_(columns), problems_(problems), fields_(fields) {}

    /// Sets the answer's condition; its session must be known.
    void read(const CsvRow& row, AnswerEntry& answer);
    /// To be called after the last row: of conditions that the file does not name, the level is
    /// part of the name only where a scene and pair have several.
    void shorten_names();

  private:
    /// Calls a condition by what it shows: scene, variants and level.
    bool name_condition(const CsvRow& row, ConditionEntry& shown);
    /// `atrium: None - Blizzard24`
    [[nodiscard]] std::string pair_name(const ConditionEntry& pair) const;
    /// A condition is the same thing in every row that is counted together.
    void check_description(const CsvRow& row, const AnswerEntry& answer);
    [[nodiscard]] std::string description_of(std::uint32_t condition) const;

    AnswerTable& table_;
    const TrialsColumns& columns_;
    FileProblems& problems_;
    TrialFields& fields_;
    /// Scene, level and two variants, to the condition's name.
    std::unordered_map<ConditionEntry, std::uint32_t, ConditionHash> named_;
    /// Condition, study and kind, to the first description and its line.
    std::unordered_map<ConditionEntry, std::pair<std::uint32_t, int>, ConditionHash> described_;
};

}  // namespace obscura::analysis
