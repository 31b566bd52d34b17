// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/counts_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "analysis/direction.h"
#include "analysis/table/table.h"
#include "analysis/table/values.h"
#include "analysis/text/natural_order.h"
#include "analysis/text/text.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

enum CountsColumn : std::size_t {
    kVariantA,
    kVariantB,
    kCountA,
    kCountB,
    kCondition,
    kHypothesis,
    kValidity,
    kScene,
    kColumnCount
};

/// In the order of CountsColumn.
const std::array<KnownColumn, kColumnCount>& known_columns() {
    static const std::array<KnownColumn, kColumnCount> columns{{
        {"variant_a",
         {"condition_A"},
         {"stimulus_a", "image_a", "technique_a", "method_a", "option_a", "variant_1", "option_1",
          "method_1", "a"}},
        {"variant_b",
         {"condition_B"},
         {"stimulus_b", "image_b", "technique_b", "method_b", "option_b", "variant_2", "option_2",
          "method_2", "b"}},
        {"count_a",
         {"count_A"},
         {"votes_a", "n_a", "wins_a", "a_votes", "a_count", "chose_a", "count_1", "votes_1",
          "n_1"}},
        {"count_b",
         {"count_B"},
         {"votes_b", "n_b", "wins_b", "b_votes", "b_count", "chose_b", "count_2", "votes_2",
          "n_2"}},
        {"condition", {}, {}},
        {"hypothesis", {}, {}},
        {"validity", {}, {}},
        {"scene", {}, {}},
    }};
    return columns;
}

class Reader {
  public:
    Reader(std::string bytes, const std::string& name, const ColumnMap& map)
        : name_(name),
          map_(map),
          file_(std::move(bytes), name),
          problems_(name),
          numbers_(!file_.has_commas()) {}

    Tally read() {
        file_.for_each_row(problems_,
                           [&](const CsvRow& row) { columns_ ? read_row(row) : read_header(row); });
        if (!columns_) {
            throw base::bad_input(
                "{}: the file is empty, allowed is a header with variant_a, variant_b, count_a, "
                "count_b and a row for each condition",
                name_);
        }
        problems_.throw_if_any();
        if (tally_.conditions.empty()) {
            throw base::bad_input("{}:{}: there is no row below the header", name_, header_line_);
        }
        std::sort(tally_.conditions.begin(), tally_.conditions.end(),
                  [](const ConditionVotes& one, const ConditionVotes& other) {
                      return naturally_before(one.id, other.id);
                  });
        tally_.source = name_;
        tally_.order = Possible<OrderVotes>::none("counts do not say which image was shown first");
        tally_.n_participants = participants();
        tally_.notes = file_.notes();
        if (const std::string names = columns_->passed_over({}); !names.empty()) {
            tally_.notes.push_back(fmt::format("columns that are not read: {}", names));
        }
        return std::move(tally_);
    }

  private:
    void read_header(const CsvRow& header) {
        header_line_ = header.line;
        columns_.emplace(header, known_columns(), map_, problems_);
        problems_.throw_if_any();
        bool any_missing = false;
        for (const CountsColumn column : {kVariantA, kVariantB, kCountA, kCountB}) {
            if (columns_->has(column)) continue;
            columns_->report_missing(column, {}, problems_);
            any_missing = true;
        }
        if (any_missing) columns_->report_names(problems_);
        problems_.throw_if_any();
    }

    void read_row(const CsvRow& row) {
        ConditionVotes condition;
        condition.variant_a = word(row, kVariantA);
        condition.variant_b = word(row, kVariantB);
        condition.votes = {count(row, kCountA), count(row, kCountB)};
        if (is_a_of(condition.variant_b, condition.variant_a)) {
            std::swap(condition.variant_a, condition.variant_b);
            std::swap(condition.votes.a, condition.votes.b);
        }
        condition.hypothesis = name(row, kHypothesis);
        condition.validity = level(row);
        condition.view = name(row, kScene);
        if (columns_->has(kCondition)) {
            condition.id = word(row, kCondition);
        } else {
            condition.id =
                fmt::format("{}{}{} - {}{}", condition.view, condition.view.empty() ? "" : ": ",
                            condition.variant_a, condition.variant_b,
                            condition.validity.empty() || condition.view.empty()
                                ? ""
                                : fmt::format(" ({})", condition.validity));
        }
        check_new(row, condition.id);
        tally_.conditions.push_back(std::move(condition));
    }

    void check_new(const CsvRow& row, const std::string& id) {
        const auto [first, is_new] = lines_.emplace(id, row.line);
        if (is_new || id.empty()) return;
        problems_.add(
            row.line,
            columns_->has(kCondition)
                ? fmt::format("column {}: '{}' is already in line {}, allowed is one row for each",
                              columns_->name(kCondition), printable(id), first->second)
                : fmt::format("'{}' is already in line {}; where they are two conditions, a column "
                              "condition names each",
                              printable(id), first->second));
    }

    void report(const CsvRow& row, CountsColumn column, std::string_view value,
                std::string_view allowed) {
        problems_.add(row.line, fmt::format("column {}: '{}', allowed {}", columns_->name(column),
                                            printable(value), allowed));
    }

    /// A name that may be missing.
    std::string name(const CsvRow& row, CountsColumn column) {
        const std::string_view field = columns_->field(row, column);
        if (is_missing_name(field)) return "";
        if (printable(field, field.size()) != field) {
            report(row, column, field, "is text without control characters");
        }
        return std::string(field);
    }

    std::string word(const CsvRow& row, CountsColumn column) {
        std::string text = name(row, column);
        if (text.empty()) {
            problems_.add(row.line, fmt::format("column {} is empty", columns_->name(column)));
        }
        return text;
    }

    std::string level(const CsvRow& row) {
        const std::string_view field = columns_->field(row, kValidity);
        if (is_missing(field)) return "";
        std::string small = lower(field);
        if (small != "low" && small != "moderate" && small != "high") {
            report(row, kValidity, field,
                   "are low, moderate, high; --map validity= passes the column over");
        }
        return small;
    }

    std::int64_t count(const CsvRow& row, CountsColumn column) {
        const std::string_view field = columns_->field(row, column);
        const auto value = numbers_.whole(field, kMaxCount);
        if (!value) report(row, column, field, fmt::format("is a whole number 0 to {}", kMaxCount));
        return value.value_or(0);
    }

    [[nodiscard]] Possible<std::int64_t> participants() const {
        const std::int64_t n = tally_.conditions.front().votes.n();
        for (const ConditionVotes& condition : tally_.conditions) {
            if (condition.votes.n() != n) {
                return Possible<std::int64_t>::none(
                    "the conditions have different numbers of votes");
            }
        }
        return n;
    }

    const std::string& name_;
    const ColumnMap& map_;
    ForeignTable file_;
    FileProblems problems_;
    NumberReader numbers_;
    std::optional<Columns> columns_;
    int header_line_ = 1;
    std::map<std::string, int> lines_;  ///< condition to the line it was met in
    Tally tally_;
};

}  // namespace

Tally parse_counts(std::string bytes, const std::string& name, const ColumnMap& map) {
    return Reader(std::move(bytes), name, map).read();
}

Tally read_counts(const std::filesystem::path& file, const ColumnMap& map) {
    return parse_counts(base::read_file(file), file.string(), map);
}

}  // namespace obscura::analysis
