// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/export/tables.h"

namespace obscura::analysis {

/// Every condition that was shown, one row for each study, kind and way it was described, in order
/// of the first showing, with its votes.
class ConditionCounter {
  public:
    void add(const TrialRecord& trial, const SessionRecord& session);
    [[nodiscard]] const std::vector<ConditionRow>& rows() const { return rows_; }

  private:
    ConditionRow& entry_of(const TrialRecord& trial, const SessionRecord& session);

    std::vector<ConditionRow> rows_;
    std::unordered_map<std::string, std::vector<std::size_t>> places_;  ///< by condition
};

}  // namespace obscura::analysis
