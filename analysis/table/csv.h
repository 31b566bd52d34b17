// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::analysis {

/// One record of a CSV file.
struct CsvRecord {
    int line = 0;  ///< where it begins, from 1
    std::vector<std::string> fields;
};

/// The records of RFC 4180 text: quotes, quotes within quotes, separators and line ends within
/// quotes. A UTF-8 byte order mark, empty lines and blanks around quotes are passed over; lines end
/// with LF, CRLF or CR. Throws bad input as `name:line: what is wrong` for quotes that do not close
/// or stand in the middle of a field, and for text that is not UTF-8.
[[nodiscard]] std::vector<CsvRecord> parse_csv(std::string_view text, const std::string& name);

/// The same one after another, so that a large file need not lie in memory as records. `take` may
/// keep what it is given; records before one that is wrong have been taken when it throws.
void for_each_csv_record(std::string_view text, const std::string& name,
                         const std::function<void(CsvRecord&&)>& take);

/// A record whose fields live only as long as the call that gets it.
struct CsvRow {
    int line = 0;  ///< where it begins, from 1
    std::span<const std::string_view> fields;
};

/// The same without a copy of each field, for large files. The text begins in `first_line`.
void for_each_csv_row(std::string_view text, const std::string& name,
                      const std::function<void(const CsvRow&)>& take, char separator = ',',
                      int first_line = 1);

/// One record with its line feed, quoted where RFC 4180 asks for it. A record of one empty field is
/// written with quotes, because a reader would take it for an empty line.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& fields);

}  // namespace obscura::analysis
