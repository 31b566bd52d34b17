// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace obscura::analysis {

/// Whether a hard case holds.
enum class Holds {
    kYes,
    kByNature,   ///< no, as the technique's own definition says; the note gives the reason
    kUndecided,  ///< times whose spread is too large to tell
    kNo,         ///< no, and nothing explains it
};

/// What a measurement is held against.
enum class HeldAgainst {
    kTruth,      ///< a closed form, or what any sound image or statistic has
    kDefinition  ///< the technique's own in double precision: nothing excuses a row that does not
                 ///< hold
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
    HeldAgainst against = HeldAgainst::kTruth;
    std::optional<double> definition = {};  ///< the same quantity as the technique is defined

    /// How far the definition is from the truth.
    [[nodiscard]] std::optional<double> by_nature() const;
    /// How far the shader is from the definition.
    [[nodiscard]] std::optional<double> numerical() const;
};

/// How many rows hold, fail by nature, are not decided and fail without a reason.
struct HardCaseCount {
    std::size_t yes = 0;
    std::size_t by_nature = 0;
    std::size_t undecided = 0;
    std::size_t no = 0;
    std::size_t numerical = 0;  ///< of all, rows held against the definition
    std::size_t numerical_holding = 0;
};
[[nodiscard]] HardCaseCount count_of(const std::vector<HardCaseRow>& rows);

/// case,technique,quantity,expected,measured,tolerance,holds,note, then
/// against,definition,by_nature,numerical; `holds` is yes, `by nature`, `not decided` or no,
/// `against` truth or definition; by_nature is expected - definition and numerical is definition -
/// measured. A number that is not finite is written as nan, inf or -inf, one that does not exist is
/// an empty cell.
[[nodiscard]] std::string hard_cases_csv(const std::vector<HardCaseRow>& rows);

/// A line for each row that fails without a reason or was not decided; empty where none is.
[[nodiscard]] std::string failing_hard_cases(const std::vector<HardCaseRow>& rows);

/// The count in a sentence.
[[nodiscard]] std::string hard_cases_in_a_sentence(const std::vector<HardCaseRow>& rows);

[[nodiscard]] std::string to_string(Holds holds);

}  // namespace obscura::analysis
