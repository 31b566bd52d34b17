// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/export/export_folder.h"
#include "analysis/export/tables.h"

namespace obscura::analysis {

/// How rows are written.
enum class Layout {
    kCsv,        ///< RFC 4180: commas, quotes where needed, LF; not known: empty
    kTsv,        ///< the same with tabs
    kBidsTsv,    ///< BIDS 1.9, "Tabular files": tabs, no line breaks within; not known: n/a
    kJsonLines,  ///< an object a line (jsonlines.org); not known: null
};

/// The ending of a file of that layout, with its dot.
[[nodiscard]] std::string_view ending_of(Layout layout);

/// Turns what stands in `line` from `begin` on into a cell of that layout.
void finish_cell(std::string& line, std::size_t begin, bool number, Layout layout);

/// `text` as a JSON string with its quotes.
[[nodiscard]] std::string json_text(std::string_view text);

/// Writes rows of a table to a file, one after another.
template <typename Row>
class TableWriter {
  public:
    /// Writes the header, where the layout has one. All must outlive the writer.
    TableWriter(const std::vector<ExportColumn<Row>>& columns, Layout layout, OutputFile& file)
        : columns_(columns), layout_(layout), file_(file), long_cells_(columns.size()) {
        for (const auto& column : columns) {
            if (layout == Layout::kJsonLines) {
                keys_.push_back((keys_.empty() ? "{" : ", ") + json_text(column.name) + ": ");
                continue;
            }
            if (!line_.empty()) line_ += separator();
            const std::size_t begin = line_.size();
            line_ += column.name;
            finish_cell(line_, begin, false, layout);
        }
        if (layout != Layout::kJsonLines) end_line("\n");
    }

    void write(const Row& row) {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            if (layout_ == Layout::kJsonLines) {
                line_ += keys_[i];
            } else if (i > 0) {
                line_ += separator();
            }
            const std::size_t begin = line_.size();
            const ExportCell<Row>& cell = columns_[i].cell;
            cell.append(row, line_);
            finish(i, begin, cell.number);
        }
        end_line(layout_ == Layout::kJsonLines ? "}\n" : "\n");
    }

  private:
    /// A long text mostly stands in many rows: what the last row had is not made anew.
    void finish(std::size_t column, std::size_t begin, bool number) {
        constexpr std::size_t kLong = 100;
        if (line_.size() - begin < kLong) return finish_cell(line_, begin, number, layout_);
        LongCell& last = long_cells_[column];
        if (std::string_view(line_).substr(begin) == last.text) {
            line_.replace(begin, std::string::npos, last.cell);
            return;
        }
        last.text = line_.substr(begin);
        finish_cell(line_, begin, number, layout_);
        last.cell = line_.substr(begin);
    }
    [[nodiscard]] char separator() const { return layout_ == Layout::kCsv ? ',' : '\t'; }
    void end_line(const char* end) {
        line_ += end;
        file_.write(line_);
        line_.clear();
    }

    /// A text and the cell that it became.
    struct LongCell {
        std::string text, cell;
    };

    const std::vector<ExportColumn<Row>>& columns_;
    Layout layout_;
    OutputFile& file_;
    std::vector<LongCell> long_cells_;
    std::vector<std::string> keys_;
    std::string line_;
};

}  // namespace obscura::analysis
