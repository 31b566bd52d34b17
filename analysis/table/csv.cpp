// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/table/csv.h"

#include <utf8.h>

#include <algorithm>
#include <deque>
#include <utility>

#include "analysis/text/text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

[[nodiscard]] base::Error problem(const std::string& name, int line, std::string_view what) {
    return base::bad_input("{}:{}: {}", name, line, what);
}

/// Line ends, CRLF as one.
[[nodiscard]] int count_lines(std::string_view text) {
    auto count = std::count(text.begin(), text.end(), '\n');
    for (auto at = text.find('\r'); at != std::string_view::npos; at = text.find('\r', at + 1)) {
        if (at + 1 == text.size() || text[at + 1] != '\n') ++count;
    }
    return static_cast<int>(count);
}

class Parser {
  public:
    Parser(std::string_view text, const std::string& name, char separator, int first_line)
        : text_(text), name_(name), separator_(separator), line_(first_line) {}

    void run(const std::function<void(const CsvRow&)>& take) {
        const auto wrong = utf8::find_invalid(text_.begin(), text_.end());
        if (wrong != text_.end()) {
            const std::string_view before(text_.data(),
                                          static_cast<std::size_t>(wrong - text_.begin()));
            throw problem(name_, line_ + count_lines(before), "the text is not UTF-8");
        }
        while (at_ < text_.size()) {
            if (skip_line_end()) continue;
            const int line = line_;
            read_record();
            take({line, fields_});
        }
    }

  private:
    [[nodiscard]] bool at_line_end() const {
        return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r';
    }

    bool skip_line_end() {
        if (at_ == text_.size() || !at_line_end()) return false;
        at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
        ++line_;
        return true;
    }

    void read_record() {
        fields_.clear();
        unquoted_.clear();
        while (true) {
            fields_.push_back(field());
            if (at_line_end()) break;
            ++at_;  // the separator
        }
        skip_line_end();
    }

    /// What is wrong with the field that begins there; it is the next one of the record.
    [[nodiscard]] base::Error at_field(int line, std::size_t begin, std::string_view what) const {
        std::string_view value = text_.substr(begin);
        value = value.substr(0, value.find_first_of("\r\n"));
        value = value.substr(0, value.find(separator_));
        return problem(
            name_, line,
            fmt::format("column {}: '{}': {}", fields_.size() + 1, printable(value, 40), what));
    }

    std::string_view field() {
        const std::size_t begin = at_;
        for (; at_ < text_.size(); ++at_) {
            const char letter = text_[at_];
            if (letter > ',' && letter != separator_) continue;  // beyond all that ends a field
            if (letter == separator_ || letter == '\n' || letter == '\r') break;
            if (letter != '"') continue;
            const std::string_view before = text_.substr(begin, at_ - begin);
            if (before.find_first_not_of(' ') == std::string_view::npos) return quoted();
            throw at_field(
                line_, begin,
                "a quote in the middle of a field, allowed is one around the whole field");
        }
        return text_.substr(begin, at_ - begin);
    }

    /// A part of the text, or a copy where it has quotes within.
    std::string_view quoted() {
        const int begin_line = line_;
        const std::size_t opening = at_;
        std::size_t begin = ++at_;
        std::string* copy = nullptr;
        while (true) {
            const std::size_t quote = text_.find('"', at_);
            if (quote == std::string_view::npos) {
                throw at_field(begin_line, opening, "a quote that is never closed");
            }
            const std::string_view part = text_.substr(begin, quote - begin);
            line_ += count_lines(text_.substr(at_, quote - at_));
            at_ = quote + 1;
            if (at_ < text_.size() && text_[at_] == '"') {
                if (copy == nullptr) copy = &unquoted_.emplace_back();
                copy->append(part);
                begin = at_++;  // the second of two quotes stands for one
                continue;
            }
            while (separator_ != ' ' && at_ < text_.size() && text_[at_] == ' ') ++at_;
            if (!at_line_end() && text_[at_] != separator_) {
                throw at_field(line_, opening,
                               "text after a closing quote, allowed is a separator or the line's "
                               "end");
            }
            return copy == nullptr ? part : std::string_view(copy->append(part));
        }
    }

    std::string_view text_;
    const std::string& name_;
    char separator_;
    std::size_t at_ = 0;
    int line_;
    std::vector<std::string_view> fields_;
    std::deque<std::string> unquoted_;  // which does not move what it holds
};

}  // namespace

std::vector<CsvRecord> parse_csv(std::string_view text, const std::string& name) {
    std::vector<CsvRecord> records;
    for_each_csv_record(text, name,
                        [&](CsvRecord&& record) { records.push_back(std::move(record)); });
    return records;
}

void for_each_csv_record(std::string_view text, const std::string& name,
                         const std::function<void(CsvRecord&&)>& take) {
    for_each_csv_row(text, name, [&](const CsvRow& row) {
        take({row.line, std::vector<std::string>(row.fields.begin(), row.fields.end())});
    });
}

void for_each_csv_row(std::string_view text, const std::string& name,
                      const std::function<void(const CsvRow&)>& take, char separator,
                      int first_line) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    Parser(text, name, separator, first_line).run(take);
}

std::string csv_line(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) {
        if (&field != &fields.front()) line += ',';
        const bool alone = fields.size() == 1 && field.empty();
        if (!alone && field.find_first_of(",\"\r\n") == std::string::npos) {
            line += field;
            continue;
        }
        line += '"';
        for (const char letter : field) {
            if (letter == '"') line += '"';
            line += letter;
        }
        line += '"';
    }
    return line + '\n';
}

}  // namespace obscura::analysis
