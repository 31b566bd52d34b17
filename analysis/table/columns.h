// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/table/csv.h"
#include "analysis/table/problems.h"

namespace obscura::analysis {

/// A column that a reader knows.
struct KnownColumn {
    std::string_view name;
    std::vector<std::string_view> also;   ///< other names of just the same
    std::vector<std::string_view> hints;  ///< what people call it, the likelier first: for advice
};

/// Which of a file's columns is which of ours, as `--map OURS=THEIRS` says it. THEIRS may be empty:
/// the file's column of our name is something else and is passed over.
class ColumnMap {
  public:
    ColumnMap() = default;
    /// Throws bad input for text without `=`, and for a column of ours that is named twice.
    explicit ColumnMap(const std::vector<std::string>& options);

    struct Entry {
        std::string ours;
        std::string theirs;
    };
    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    [[nodiscard]] const Entry* find(std::string_view ours) const;

  private:
    std::vector<Entry> entries_;
};

/// A name as it is compared: small letters and digits only, so that `Condition.A` is `condition_A`.
[[nodiscard]] std::string bare_name(std::string_view name);

/// Where each known column stands in a row.
class Columns {
  public:
    /// Adds to `problems` what the map says wrongly, and columns of which two could be meant.
    /// `known` must outlive this.
    Columns(const CsvRow& header, std::span<const KnownColumn> known, const ColumnMap& map,
            FileProblems& problems);

    [[nodiscard]] bool has(std::size_t column) const { return place_[column].has_value(); }
    /// The field without blanks around it; empty where the file has no such column.
    [[nodiscard]] std::string_view field(const CsvRow& row, std::size_t column) const;
    /// What the file calls it; ours where it has none.
    [[nodiscard]] std::string_view name(std::size_t column) const;
    /// Passes a column over after all.
    void drop(std::size_t column) { place_[column].reset(); }

    /// The column is missing: says so, with the likeliest of the file's in place of it.
    void report_missing(std::size_t column, std::span<const std::size_t> instead,
                        FileProblems& problems) const;
    /// Says once which columns the file has.
    void report_names(FileProblems& problems) const;
    /// The option that gives this column the likeliest of the file's that is not in use.
    [[nodiscard]] std::optional<std::string> advice(std::size_t column) const;
    /// Named columns that are not known, nor `ignored`, for a note; empty text where there is none.
    [[nodiscard]] std::string passed_over(std::span<const std::string_view> ignored) const;

  private:
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    void place_mapped(const ColumnMap& map, FileProblems& problems);
    void place_named(const ColumnMap& map, FileProblems& problems);
    [[nodiscard]] bool is_used(std::size_t place) const;

    std::span<const KnownColumn> known_;
    int line_;
    std::vector<std::string> names_;                 ///< the file's
    std::vector<std::optional<std::size_t>> place_;  ///< of each known column
};

/// `--map OURS=THEIRS`, quoted for a shell where that needs it.
[[nodiscard]] std::string map_option(std::string_view ours, std::string_view theirs);

}  // namespace obscura::analysis
