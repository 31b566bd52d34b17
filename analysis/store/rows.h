// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <soci/soci.h>

#include <algorithm>
#include <cassert>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/store/columns.h"

namespace obscura::analysis {

/// The table's columns with commas between them, each after `prefix`.
template <typename Record>
std::string column_names(const RecordTable<Record>& table, const char* prefix) {
    std::string names;
    for (const Column<Record>& column : table.columns) {
        if (!names.empty()) names += ", ";
        names += prefix;
        names += column.name;
    }
    return names;
}

/// The table with some of its columns.
template <typename Record>
RecordTable<Record> part_of(const RecordTable<Record>& table,
                            const std::vector<std::string_view>& names) {
    RecordTable<Record> part{table.name, {}};
    for (const Column<Record>& column : table.columns) {
        if (std::find(names.begin(), names.end(), column.name) != names.end()) {
            part.columns.push_back(column);
        }
    }
    assert(part.columns.size() == names.size());
    return part;
}

/// Adds the record as a row.
template <typename Record>
void insert(soci::session& session, const RecordTable<Record>& table, const Record& record) {
    std::vector<Cell> cells(table.columns.size());
    soci::statement statement(session);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Column<Record>& column = table.columns[i];
        Cell& cell = cells[i];
        column.to_cell(record, cell);
        switch (column.type) {
            case CellType::kText:
                statement.exchange(soci::use(cell.text, cell.indicator));
                break;
            case CellType::kInteger:
                statement.exchange(soci::use(cell.integer, cell.indicator));
                break;
            case CellType::kReal:
                statement.exchange(soci::use(cell.real, cell.indicator));
                break;
        }
    }
    statement.alloc();
    statement.prepare(fmt::format("INSERT INTO {} ({}) VALUES ({})", table.name,
                                  column_names(table, ""), column_names(table, ":")));
    statement.define_and_bind();
    statement.execute(true);
}

/// Rows of a table, one after another.
template <typename Record>
class Rows {
  public:
    /// `rest` is what follows FROM, `prefix` the table's name in it; its values are in `values`.
    Rows(soci::session& session, const RecordTable<Record>& table, const std::string& rest,
         const std::vector<std::string>& values = {}, const char* prefix = "")
        : table_(table), cells_(table.columns.size()), statement_(session) {
        for (const std::string& value : values) statement_.exchange(soci::use(value));
        for (std::size_t i = 0; i < cells_.size(); ++i) receive(table.columns[i].type, cells_[i]);
        statement_.alloc();
        statement_.prepare(fmt::format("SELECT {} FROM {}", column_names(table, prefix), rest));
        statement_.define_and_bind();
        statement_.execute();
    }

    /// The next row into `record`; false when there is none.
    bool next(Record& record) {
        if (!statement_.fetch()) return false;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            table_.columns[i].from_cell(record, cells_[i]);
        }
        return true;
    }

  private:
    void receive(CellType type, Cell& cell) {
        switch (type) {
            case CellType::kText:
                statement_.exchange(soci::into(cell.text, cell.indicator));
                break;
            case CellType::kInteger:
                statement_.exchange(soci::into(cell.integer, cell.indicator));
                break;
            case CellType::kReal:
                statement_.exchange(soci::into(cell.real, cell.indicator));
                break;
        }
    }

    const RecordTable<Record>& table_;
    std::vector<Cell> cells_;
    soci::statement statement_;
};

/// Rows of a table; `rest` is what follows its name, with named values from `values`.
template <typename Record>
std::vector<Record> select(soci::session& session, const RecordTable<Record>& table,
                           const std::string& rest, const std::vector<std::string>& values = {}) {
    Rows<Record> rows(session, table, fmt::format("{} {}", table.name, rest), values);
    std::vector<Record> records;
    for (Record record; rows.next(record);) records.push_back(record);
    return records;
}

}  // namespace obscura::analysis
