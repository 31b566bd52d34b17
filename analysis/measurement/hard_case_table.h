// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace obscura::analysis {

/// Whether a hard case holds.
enum class Holds {
    kYes,
    kByNature,  ///< no, as the technique's own definition says; the note gives the reason
    kNo,        ///< no, and nothing explains it
};

/// One quantity of one hard case on one technique or statistic.
struct HardCaseRow {
    std::string name;  ///< column `case`: number and title
    std::string technique;
    std::string quantity;
    double expected = 0.0;
    double measured = 0.0;
    double tolerance = 0.0;
    Holds holds = Holds::kNo;
    std::string note;
};

/// How many rows hold, fail by nature and fail without a reason.
struct HardCaseCount {
    std::size_t yes = 0;
    std::size_t by_nature = 0;
    std::size_t no = 0;
};
[[nodiscard]] HardCaseCount count_of(const std::vector<HardCaseRow>& rows);

/// case,technique,quantity,expected,measured,tolerance,holds,note; `holds` is yes, `by nature` or
/// no. A number that is not finite is written as nan, inf or -inf.
[[nodiscard]] std::string hard_cases_csv(const std::vector<HardCaseRow>& rows);

/// The count in a sentence.
[[nodiscard]] std::string hard_cases_in_a_sentence(const std::vector<HardCaseRow>& rows);

[[nodiscard]] std::string to_string(Holds holds);

}  // namespace obscura::analysis
