// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/table/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "analysis/table/decode.h"
#include "analysis/table/json_rows.h"
#include "analysis/table/values.h"

namespace obscura::analysis {
namespace {

/// Those that may stand in a header, the likelier first. A blank parts fields only where none of
/// the others does.
constexpr std::array<char, 4> kSeparators{',', ';', '\t', '|'};

/// The separator that the line has most of, outside of quotes.
char separator_of(std::string_view line) {
    std::array<std::size_t, kSeparators.size()> counts{};
    bool in_quotes = false;
    bool has_blank = false;
    for (const char letter : line) {
        if (letter == '"') in_quotes = !in_quotes;
        if (in_quotes) continue;
        const auto* known = std::find(kSeparators.begin(), kSeparators.end(), letter);
        if (known != kSeparators.end())
            ++counts.at(static_cast<std::size_t>(known - kSeparators.begin()));
        has_blank |= letter == ' ';
    }
    const auto* most = std::max_element(counts.begin(), counts.end());
    if (*most == 0) return has_blank ? ' ' : ',';
    return kSeparators.at(static_cast<std::size_t>(most - counts.begin()));
}

std::string_view without_blank_lines(std::string_view text, int& line) {
    while (!text.empty() && (text.front() == '\n' || text.front() == '\r')) {
        text.remove_prefix(text.starts_with("\r\n") ? 2 : 1);
        ++line;
    }
    return text;
}

bool is_empty(std::string_view field) { return trimmed(field).empty(); }

bool all_empty(std::span<const std::string_view> fields) {
    return std::all_of(fields.begin(), fields.end(), is_empty);
}

bool is_number(std::string_view field) {
    constexpr std::int64_t kMost = 1'000'000'000;
    return NumberReader(false).whole(trimmed(field), kMost).has_value();
}

/// An array or object begins, and not a header whose first name stands in brackets.
bool looks_like_json(std::string_view text) {
    constexpr std::size_t kLooked = 1000;
    const std::string_view start = trimmed(text.substr(0, kLooked));
    if (!start.starts_with('[') && !start.starts_with('{')) return false;
    const std::string_view next = trimmed(start.substr(1));
    constexpr std::string_view kBegins = "{[}]\"-0123456789";
    return next.empty() || kBegins.find(next.front()) != std::string_view::npos;
}

/// Gives each row the header's width.
class Widths {
  public:
    Widths(FileProblems& problems, const std::function<void(const CsvRow&)>& take)
        : problems_(problems), take_(take) {}

    void take(const CsvRow& row) {
        if (all_empty(row.fields)) return;
        if (width_ == 0) {
            read_header(row);
        } else {
            read_row(row);
        }
    }
    [[nodiscard]] bool has_row_numbers() const { return has_row_numbers_; }

  private:
    void read_header(const CsvRow& row) {
        width_ = named_ = row.fields.size();
        while (is_empty(row.fields[named_ - 1])) --named_;
        take_(row);
    }

    void read_row(const CsvRow& row) {
        std::span<const std::string_view> fields = row.fields;
        if (is_first_) {
            has_row_numbers_ = fields.size() == width_ + 1 && !is_empty(fields.back()) &&
                               is_number(fields.front());
            is_first_ = false;
        }
        if (has_row_numbers_ && is_number(fields.front())) fields = fields.subspan(1);
        if (fields.size() > width_ && all_empty(fields.subspan(width_))) {
            fields = fields.first(width_);
        }
        if (fields.size() < width_ && fields.size() >= named_) {
            filled_.assign(fields.begin(), fields.end());
            filled_.resize(width_);
            fields = filled_;
        }
        if (fields.size() != width_) {
            problems_.add(row.line, fmt::format("the row has {} fields, the header has {}",
                                                row.fields.size(), width_));
            return;
        }
        take_({row.line, fields});
    }

    FileProblems& problems_;
    const std::function<void(const CsvRow&)>& take_;
    std::size_t width_ = 0;  ///< 0: no header yet
    std::size_t named_ = 0;  ///< without unnamed columns at the end
    bool is_first_ = true;
    bool has_row_numbers_ = false;
    std::vector<std::string_view> filled_;
};

}  // namespace

ForeignTable::ForeignTable(std::string bytes, const std::string& name) : name_(name) {
    DecodedText decoded = decode(std::move(bytes), name);
    text_ = std::move(decoded.text);
    if (!decoded.encoding.empty()) {
        notes_.push_back(fmt::format("the text is no UTF-8, it is read as {}", decoded.encoding));
    }
    is_json_ = looks_like_json(text_);
    rest_ = text_;
    if (!is_json_) find_separator();
}

void ForeignTable::find_separator() {
    rest_ = without_blank_lines(rest_, first_line_);
    const std::string_view line = rest_.substr(0, rest_.find_first_of("\r\n"));
    std::string_view word = trimmed(line);
    // What a spreadsheet takes the separator from; it may itself stand in quotes.
    if (word.size() > 1 && word.front() == '"' && word.back() == '"') {
        word = word.substr(1, word.size() - 2);
    }
    constexpr std::string_view kSep = "sep=";
    if (word.starts_with(kSep) && word.size() <= kSep.size() + 1) {
        separator_ = word.size() > kSep.size() ? word.back() : '\t';  // a tab was trimmed
        rest_ = without_blank_lines(rest_.substr(line.size()), first_line_);
        return;
    }
    separator_ = separator_of(line);
}

void ForeignTable::for_each_row(FileProblems& problems,
                                const std::function<void(const CsvRow&)>& take) {
    if (is_json_) {
        for_each_json_row(rest_, name_, take);
        return;
    }
    Widths widths(problems, take);
    for_each_csv_row(
        rest_, name_, [&](const CsvRow& row) { widths.take(row); }, separator_, first_line_);
    if (widths.has_row_numbers()) {
        notes_.emplace_back(
            "each row begins with a number that the header has no name for; it is passed over as "
            "the row's");
    }
}

}  // namespace obscura::analysis
