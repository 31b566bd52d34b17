// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/conclusions/looks.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Why the test of a secondary hypothesis has no corrected p.
inline constexpr const char* kSecondary = "secondary: it stands alone";

/// Tests of all verdicts, corrected together. What it holds follows from the study and not from who
/// answered: a test that could not be computed is one of them, with p = 1.
class CorrectedTests {
  public:
    /// `look`, which must outlive it: where looks are spent for, every p is that after spending.
    explicit CorrectedTests(const Possible<LookResult>& look) : look_(look) {}

    /// The place of the test in the family.
    std::size_t add(const Possible<PValue>& p);
    /// After the last was added.
    void correct();
    [[nodiscard]] std::size_t size() const { return p_values_.size(); }
    /// The corrected p; no value where the test could not be computed.
    [[nodiscard]] Possible<double> at(std::size_t place) const;
    /// ` (.023 after Holm's correction for 4 tests)`, and after spending where looks are spent for;
    /// of a secondary hypothesis that it is none of them.
    [[nodiscard]] std::string words(const Possible<double>& p_holm, bool is_primary) const;

  private:
    const Possible<LookResult>& look_;
    std::vector<double> p_values_;
    std::vector<bool> is_computed_;
    std::vector<double> corrected_;
};

[[nodiscard]] bool is_significant(const Possible<double>& p);

}  // namespace obscura::analysis
