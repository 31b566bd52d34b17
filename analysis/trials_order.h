// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "analysis/answers.h"
#include "analysis/table/values.h"
#include "analysis/trials_columns.h"

namespace obscura::analysis {

/// The largest number of a trial that is read.
inline constexpr std::int64_t kLastIndex = 2'000'000'000;

/// What was shown first, by the columns first_shown, order and response.
class OrderReader {
  public:
    OrderReader(const TrialsColumns& columns, FileProblems& problems, NumberReader& numbers);

    /// Sets first_shown, or trial_index where order numbers the trials.
    void read(const CsvRow& row, AnswerEntry& answer);
    /// Whether response says what first_shown and the choice say.
    void check_response(const CsvRow& row, const AnswerEntry& answer);

    /// Why the file does not say what was shown first; empty where it does.
    [[nodiscard]] const std::string& unknown() const { return unknown_; }
    [[nodiscard]] bool numbers_trials() const { return is_number_.value_or(false); }

  private:
    void read_order(const CsvRow& row, AnswerEntry& answer);

    const TrialsColumns& columns_;
    FileProblems& problems_;
    NumberReader& numbers_;
    std::string unknown_;
    std::optional<bool> is_number_;  ///< what order is; nothing before the first row
};

}  // namespace obscura::analysis
