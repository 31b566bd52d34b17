// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "analysis/table/columns.h"

namespace obscura::analysis {

/// The columns of a file of trials that are read.
enum TrialsColumn : std::size_t {
    kObserver,
    kConditionA,
    kConditionB,
    kIsASelected,
    kChoseB,
    kChosen,
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
    kStudyA,
    kSessionState,
    kResponseTime,
    kResponseTimeMs,
    kExpected,
    kRepeats,
    kExclusion,
    kStudyPlan,
    kColumnCount
};

/// Where each of them stands in a row.
class TrialsColumns : public Columns {
  public:
    /// Adds to `problems` what is missing, with the likeliest column in place of it. Of the columns
    /// is_A_selected, chose_B and chosen the first that is there is read, the others are not;
    /// response only where first_shown gives it a meaning.
    TrialsColumns(const CsvRow& header, const ColumnMap& map, FileProblems& problems);

    /// `column NAME: 'value', allowed ...`; with NAME the file's own.
    void report(FileProblems& problems, int line, TrialsColumn column, std::string_view value,
                std::string_view allowed) const;
    /// The named columns that are not read and no export of ours has, in words; or nothing.
    [[nodiscard]] std::string passed_over() const;
};

}  // namespace obscura::analysis
