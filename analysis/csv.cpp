// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/csv.h"

#include <utility>

#include "analysis/text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class Parser {
  public:
    Parser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    void run(const std::function<void(CsvRecord&&)>& take) {
        if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
        while (at_ < text_.size()) {
            if (skip_line_end()) continue;
            CsvRecord record{line_, {}};
            read_record(record.fields);
            take(std::move(record));
        }
    }

  private:
    [[nodiscard]] bool at_line_end() const {
        return at_ == text_.size() || text_[at_] == '\n' || text_.substr(at_, 2) == "\r\n";
    }

    bool skip_line_end() {
        if (at_ == text_.size() || !at_line_end()) return false;
        at_ += text_[at_] == '\r' ? 2 : 1;
        ++line_;
        return true;
    }

    void read_record(std::vector<std::string>& fields) {
        while (true) {
            fields.push_back(at_ < text_.size() && text_[at_] == '"' ? quoted() : plain());
            if (at_line_end()) break;
            ++at_;  // the comma
        }
        skip_line_end();
    }

    std::string plain() {
        const std::size_t begin = at_;
        while (!at_line_end() && text_[at_] != ',') {
            if (text_[at_] == '"') throw problem(line_, "a quote in the middle of a field");
            ++at_;
        }
        return std::string(text_.substr(begin, at_ - begin));
    }

    std::string quoted() {
        const int begin_line = line_;
        std::string field;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '"') {
                ++at_;
                if (at_line_end() || text_[at_] == ',') return field;
                if (text_[at_] != '"') throw problem(line_, "text after a closing quote");
            } else if (text_[at_] == '\n') {
                ++line_;
            }
            field += text_[at_];
        }
        throw problem(begin_line, "a quote that is never closed");
    }

    [[nodiscard]] base::Error problem(int line, std::string_view what) const {
        return base::bad_input("{}:{}: {}", name_, line, what);
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    int line_ = 1;
};

void require_utf8(std::string_view text, const std::string& name) {
    if (is_utf8(text)) return;
    int line = 1;
    while (!text.empty()) {
        const auto end = text.find('\n');
        if (!is_utf8(text.substr(0, end))) break;
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        ++line;
    }
    throw base::bad_input("{}:{}: the text is not UTF-8", name, line);
}

}  // namespace

std::vector<CsvRecord> parse_csv(std::string_view text, const std::string& name) {
    std::vector<CsvRecord> records;
    for_each_csv_record(text, name,
                        [&](CsvRecord&& record) { records.push_back(std::move(record)); });
    return records;
}

void for_each_csv_record(std::string_view text, const std::string& name,
                         const std::function<void(CsvRecord&&)>& take) {
    require_utf8(text, name);
    Parser(text, name).run(take);
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
