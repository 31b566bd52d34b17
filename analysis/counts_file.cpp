// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/counts_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "analysis/csv.h"
#include "analysis/direction.h"
#include "analysis/natural_order.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

constexpr std::array<std::string_view, 7> kColumns{
    "condition", "hypothesis", "validity", "variant_a", "variant_b", "count_a", "count_b"};

/// Gathers what is wrong, so that all of it is said at once.
class Reader {
  public:
    explicit Reader(const std::string& name) : name_(name) {}

    Tally read(const std::vector<CsvRecord>& records) {
        if (records.empty()) {
            throw base::bad_input(
                "{}: the file is empty, allowed is the header {} and a row for "
                "each condition",
                name_, fmt::join(kColumns, ","));
        }
        read_header(records.front());
        if (problems_.empty()) {
            for (std::size_t i = 1; i < records.size(); ++i) read_row(records[i]);
            if (records.size() == 1)
                report(records.front().line, "there is no row below the header");
        }
        if (!problems_.empty()) throw base::bad_input("{}", fmt::join(problems_, "\n"));
        std::sort(tally_.conditions.begin(), tally_.conditions.end(),
                  [](const ConditionVotes& one, const ConditionVotes& other) {
                      return naturally_before(one.id, other.id);
                  });
        tally_.source = name_;
        tally_.order = Possible<OrderVotes>::none("counts do not say which image was shown first");
        tally_.n_participants = participants();
        return std::move(tally_);
    }

  private:
    void report(int line, std::string_view what) {
        problems_.push_back(fmt::format("{}:{}: {}", name_, line, what));
    }

    void read_header(const CsvRecord& header) {
        for (std::size_t i = 0; i < header.fields.size(); ++i) {
            const std::string& field = header.fields[i];
            if (std::find(kColumns.begin(), kColumns.end(), field) == kColumns.end()) {
                report(header.line, fmt::format("unknown column '{}', allowed are {}", field,
                                                fmt::join(kColumns, ", ")));
            } else if (!place_.emplace(field, i).second) {
                report(header.line, fmt::format("column {} stands there twice", field));
            }
        }
        for (const std::string_view column : kColumns) {
            if (!place_.contains(column)) {
                report(header.line, fmt::format("column {} is missing", column));
            }
        }
    }

    void read_row(const CsvRecord& row) {
        if (row.fields.size() != place_.size()) {
            report(row.line, fmt::format("the row has {} fields, allowed are {}", row.fields.size(),
                                         place_.size()));
            return;
        }
        ConditionVotes condition;
        condition.id = word(row, "condition");
        condition.hypothesis = row.fields[place_.at("hypothesis")];
        condition.validity = word(row, "validity");
        condition.variant_a = word(row, "variant_a");
        condition.variant_b = word(row, "variant_b");
        condition.votes = {count(row, "count_a"), count(row, "count_b")};
        if (is_a_of(condition.variant_b, condition.variant_a)) {
            std::swap(condition.variant_a, condition.variant_b);
            std::swap(condition.votes.a, condition.votes.b);
        }
        const std::string& validity = condition.validity;
        if (!validity.empty() && validity != "low" && validity != "moderate" &&
            validity != "high") {
            report(row.line,
                   fmt::format("column validity: '{}', allowed are low, moderate, high", validity));
        }
        const auto [first, is_new] = lines_.emplace(condition.id, row.line);
        if (!is_new && !condition.id.empty()) {
            report(row.line, fmt::format("column condition: '{}' is already in line {}, allowed is "
                                         "one row for each",
                                         condition.id, first->second));
        }
        tally_.conditions.push_back(std::move(condition));
    }

    std::string word(const CsvRecord& row, std::string_view column) {
        const std::string& field = row.fields[place_.at(column)];
        if (field.empty()) report(row.line, fmt::format("column {} is empty", column));
        return field;
    }

    std::int64_t count(const CsvRecord& row, std::string_view column) {
        const std::string& field = row.fields[place_.at(column)];
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
        if (error != std::errc() || end != field.data() + field.size() || value < 0 ||
            value > kMaxCount) {
            report(row.line, fmt::format("column {}: '{}', allowed is a whole number 0 to {}",
                                         column, field, kMaxCount));
            return 0;
        }
        return value;
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
    std::map<std::string_view, std::size_t> place_;  ///< column to field; views into the header
    std::map<std::string, int> lines_;               ///< condition to the line it was met in
    std::vector<std::string> problems_;
    Tally tally_;
};

}  // namespace

Tally parse_counts(std::string_view text, const std::string& name) {
    const auto records = parse_csv(text, name);
    return Reader(name).read(records);
}

Tally read_counts(const std::filesystem::path& file) {
    return parse_counts(base::read_file(file), file.string());
}

}  // namespace obscura::analysis
