// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "analysis/answers.h"
#include "analysis/table/csv.h"
#include "analysis/trials_columns.h"

namespace obscura::analysis {

/// The fields of a row of trials; texts become numbers of AnswerTable::names at once. What it is
/// made from must outlive it.
class TrialFields {
  public:
    TrialFields(AnswerTable& table, const TrialsColumns& columns, FileProblems& problems)
        : table_(table), columns_(columns), problems_(problems) {}

    [[nodiscard]] std::string_view field(const CsvRow& row, TrialsColumn column) const {
        return columns_.field(row, column);
    }
    void report(const CsvRow& row, TrialsColumn column, std::string_view value,
                std::string_view allowed) {
        columns_.report(problems_, row.line, column, value, allowed);
    }

    /// 0 for a field that is missing. A text that no name may be is a problem.
    std::uint32_t number_of(const CsvRow& row, TrialsColumn column);
    /// The same; a field that is missing is a problem.
    std::uint32_t needed(const CsvRow& row, TrialsColumn column);

  private:
    void check_name(const CsvRow& row, TrialsColumn column, std::string_view text);

    AnswerTable& table_;
    const TrialsColumns& columns_;
    FileProblems& problems_;
    std::array<std::uint32_t, kColumnCount> last_{};  ///< number of each column's text
};

}  // namespace obscura::analysis
