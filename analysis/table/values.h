// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace obscura::analysis {

// How R, pandas, spreadsheets, PsychoPy, jsPsych and OpenSesame write values. Capitals do not
// matter, and blanks around a value have been taken off.

/// Without blanks, tabs, no-break spaces and byte order marks around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// In small letters, ASCII's only.
[[nodiscard]] std::string lower(std::string_view text);

/// Nothing, NA, N/A, NaN, null, undefined: a name that is not there. "None" is a name: that of a
/// variant.
[[nodiscard]] bool is_missing_name(std::string_view text);

/// The same, and None, nil, missing, a point, a dash or two: no number, no yes or no.
[[nodiscard]] bool is_missing(std::string_view text);

/// true, t, yes, y and 1 (also 1.0); false, f, no, n and 0; true and false as a spreadsheet writes
/// them in some other languages; else nothing.
[[nodiscard]] std::optional<bool> truth(std::string_view text);

/// Numbers of one table.
class NumberReader {
  public:
    /// Where commas part the fields, one within a number is no decimal comma.
    explicit NumberReader(bool may_have_decimal_commas) : may_(may_have_decimal_commas) {}

    /// A finite number, with a decimal point or comma; nothing for any other text, and for one with
    /// a comma where others have a point.
    [[nodiscard]] std::optional<double> number(std::string_view text);
    /// The same where it is whole and from 0 to `most`, which is at most 2^53: 12, 12.0, 1e+05.
    [[nodiscard]] std::optional<std::int64_t> whole(std::string_view text, std::int64_t most);

  private:
    bool may_;
    bool has_point_ = false;
    bool has_comma_ = false;
};

}  // namespace obscura::analysis
