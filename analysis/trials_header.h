// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/csv.h"

namespace obscura::analysis {

/// The columns of a file of trials that are read.
enum TrialsColumn : std::size_t {
    kObserver,
    kConditionA,
    kConditionB,
    kIsASelected,
    kSessionId,
    kScene,
    kOrder,
    kCondition,
    kHypothesis,
    kValidity,
    kFirstShown,
    kResponse,
    kTrialIndex,
    kKind,
    kStudy,
    kSessionState,
    kResponseTime,
    kExpected,
    kRepeats,
    kExclusion,
    kColumnCount
};
inline constexpr std::array<std::string_view, kColumnCount> kColumnNames{
    "observer",      "condition_A",   "condition_B", "is_A_selected", "session_id",
    "scene",         "order",         "condition",   "hypothesis",    "validity",
    "first_shown",   "response",      "trial_index", "kind",          "study",
    "session_state", "response_time", "expected",    "repeats",       "exclusion"};
/// The first so many are needed.
inline constexpr std::size_t kNeededColumns = 4;
/// Another name of the column observer.
inline constexpr std::string_view kOtherObserver = "participant_id";
/// Another name of the column response_time, that of the exported file.
inline constexpr std::string_view kOtherResponseTime = "response_time (s)";

/// What is wrong with a file, so that all of it is said at once; the first hundred in full.
class FileProblems {
  public:
    /// `file` stands for the file in messages and must outlive this.
    explicit FileProblems(const std::string& file) : file_(file) {}

    void add(int line, std::string_view what);
    void add(int line, TrialsColumn column, std::string_view value, std::string_view allowed);
    /// Throws bad input that lists what was added.
    void throw_if_any() const;

  private:
    const std::string& file_;
    std::vector<std::string> lines_;
    std::size_t count_ = 0;
};

/// Where each column stands in a row.
class TrialsHeader {
  public:
    /// Adds unknown columns, columns that stand there twice and needed ones that are missing.
    TrialsHeader(const CsvRow& record, FileProblems& problems);

    [[nodiscard]] bool has(TrialsColumn column) const { return place_[column].has_value(); }
    [[nodiscard]] std::size_t width() const { return width_; }
    /// The field, or empty text where the file has no such column. The row has width() fields.
    [[nodiscard]] std::string_view field(const CsvRow& row, TrialsColumn column) const {
        return place_[column] ? row.fields[*place_[column]] : std::string_view();
    }

  private:
    std::array<std::optional<std::size_t>, kColumnCount> place_;
    std::size_t width_;
};

}  // namespace obscura::analysis
