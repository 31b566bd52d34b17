// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/answers.h"
#include "analysis/table/csv.h"
#include "analysis/trials_columns.h"

namespace obscura::analysis {

/// Finds what stands in a file of trials more than once.
class RepeatFinder {
  public:
    /// A row that is kept as the table's next answer.
    void add(const CsvRow& row);
    /// The number of a trial in its session; -1 is none.
    void add_index(const AnswerEntry& answer, int line);
    /// Two trials of a session with one number are one trial twice.
    void report_equal_indices(const TrialsColumns& columns, FileProblems& problems);
    /// Rows that are equal in every column, and participants who gave several votes for a
    /// condition, in words that say what the analysis makes of them.
    [[nodiscard]] std::vector<std::string> notes(const AnswerTable& table);

  private:
    struct Seen {
        std::uint64_t key = 0;
        int line = 0;
    };
    void note_equal_rows(std::vector<std::string>& notes);
    void note_repeated_votes(const AnswerTable& table, std::vector<std::string>& notes) const;

    std::vector<Seen> rows_;     ///< by their hash, in the order of the answers until notes() sorts
    std::vector<Seen> indices_;  ///< by session and number
};

}  // namespace obscura::analysis
