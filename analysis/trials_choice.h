// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/trials_columns.h"

namespace obscura::analysis {

/// Which variant a row says was chosen: by is_A_selected or chose_B (yes or no), or by chosen: the
/// variant's name, A or B, 1 or 2, and where that is clear 0 or 1, left or right, first or second.
/// What 1, left and first mean is clear where the names of the variants' two columns say it
/// (stimulus_left, image_1, stimulus[0]), for first and second also from first_shown.
class ChoiceReader {
  public:
    ChoiceReader(const TrialsColumns& columns, FileProblems& problems);

    /// Whether the row has an answer at all.
    [[nodiscard]] bool is_answered(const CsvRow& row) const;
    /// Whether A was chosen; adds to the problems what is not clear. `first_shown` is A, B, or 0
    /// where it is not known.
    [[nodiscard]] bool is_a_chosen(const CsvRow& row, char first_shown);
    /// Adds what only the whole file shows: a column of nothing but 1, which may count from 0 or 1.
    void finish();

  private:
    [[nodiscard]] bool from_yes_or_no(const CsvRow& row);
    [[nodiscard]] std::optional<bool> named_variant(const CsvRow& row,
                                                    std::string_view value) const;
    [[nodiscard]] std::optional<bool> labelled(std::string_view value, char first_shown);
    [[nodiscard]] std::optional<bool> numbered(std::string_view value);
    void read_labels();
    [[nodiscard]] std::string allowed() const;

    const TrialsColumns& columns_;
    FileProblems& problems_;
    TrialsColumn column_;                 ///< that is read
    std::map<std::string, bool> labels_;  ///< to whether it is A
    int first_number_ = 1;                ///< of the two that number the variants
    bool first_number_is_a_ = true;
    std::array<int, 3> number_lines_{};  ///< where 0, 1 and 2 were met last; 0: nowhere
    int line_ = 0;
};

}  // namespace obscura::analysis
