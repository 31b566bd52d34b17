// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/table/csv.h"
#include "analysis/table/problems.h"

namespace obscura::analysis {

/// A table with a header as people's programs write it: fields parted by commas, semicolons, tabs,
/// bars or blanks (told from the header, or by a first line `sep=;`), in the encodings of decode();
/// or JSON, an object a row: an array of objects, of such arrays, or one object after another, as
/// jsPsych writes. A JSON object's members are the columns; those within a short array or an object
/// are called `name[0]` and `name.member`.
class ForeignTable {
  public:
    /// Throws bad input for text in no known encoding. `name` stands for the file in messages and
    /// must outlive this.
    ForeignTable(std::string bytes, const std::string& name);

    /// The header, then every row, with as many fields as that. A row may lack unnamed columns at
    /// its end, may have empty fields beyond the header, and may begin with a row's number that the
    /// header has no name for, as R writes it; other widths go to `problems`. Rows of nothing but
    /// empty fields are passed over. Throws bad input for what is neither CSV nor JSON. To be
    /// called once.
    void for_each_row(FileProblems& problems, const std::function<void(const CsvRow&)>& take);

    /// Commas part the fields, so that none is a decimal comma.
    [[nodiscard]] bool has_commas() const { return separator_ == ',' && !is_json_; }
    /// What was taken for granted, in words for the person at the terminal; complete after
    /// for_each_row.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  private:
    void find_separator();

    const std::string& name_;
    std::string text_;
    std::string_view rest_;  ///< of the text, without the line sep=
    int first_line_ = 1;
    char separator_ = ',';
    bool is_json_ = false;
    std::vector<std::string> notes_;
};

}  // namespace obscura::analysis
