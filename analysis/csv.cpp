// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/csv.h"

#include <algorithm>
#include <deque>
#include <fstream>
#include <utility>

#include "analysis/text.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

[[nodiscard]] base::Error problem(const std::string& name, int line, std::string_view what) {
    return base::bad_input("{}:{}: {}", name, line, what);
}

/// Whole records of a text that may come in pieces.
class Parser {
  public:
    explicit Parser(const std::string& name) : name_(name) {}

    /// `text` ends with a record.
    void run(std::string_view text, const std::function<void(const CsvRow&)>& take) {
        text_ = text;
        at_ = 0;
        require_utf8();
        while (at_ < text_.size()) {
            if (skip_line_end()) continue;
            const int line = line_;
            read_record();
            take({line, fields_});
        }
    }

  private:
    /// Piece by piece, none of which parts a letter.
    void require_utf8() const {
        constexpr std::size_t kPiece = std::size_t{1} << 16U;
        for (std::size_t begin = 0; begin < text_.size();) {
            const std::size_t line_end = text_.find('\n', std::min(begin + kPiece, text_.size()));
            const std::size_t end =
                line_end == std::string_view::npos ? text_.size() : line_end + 1;
            if (!is_utf8(text_.substr(begin, end - begin))) throw not_utf8(begin);
            begin = end;
        }
    }

    /// With the first line from `begin` on that is not.
    [[nodiscard]] base::Error not_utf8(std::size_t begin) const {
        auto line =
            line_ + static_cast<int>(std::count(
                        text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
        for (std::string_view rest = text_.substr(begin);; ++line) {
            const auto end = rest.find('\n');
            if (end == std::string_view::npos || !is_utf8(rest.substr(0, end))) break;
            rest.remove_prefix(end + 1);
        }
        return problem(name_, line, "the text is not UTF-8");
    }

    [[nodiscard]] bool at_line_end() const {
        return at_ == text_.size() || text_[at_] == '\n' || text_.substr(at_, 2) == "\r\n";
    }

    bool skip_line_end() {
        if (at_ == text_.size() || !at_line_end()) return false;
        at_ += text_[at_] == '\r' ? 2 : 1;
        ++line_;
        return true;
    }

    void read_record() {
        fields_.clear();
        unquoted_.clear();
        while (true) {
            fields_.push_back(at_ < text_.size() && text_[at_] == '"' ? quoted() : plain());
            if (at_line_end()) break;
            ++at_;  // the comma
        }
        skip_line_end();
    }

    /// What is wrong with the field that begins there; it is the next one of the record.
    [[nodiscard]] base::Error at_field(int line, std::size_t begin, std::string_view what) const {
        constexpr std::size_t kShown = 40;
        std::string_view value = text_.substr(begin);
        value = value.substr(0, value.find_first_of(",\r\n"));
        std::size_t length = std::min(value.size(), kShown);
        // Cut only where a letter begins: bytes 10xxxxxx continue one in UTF-8.
        while (length > 0 && length < value.size() &&
               (static_cast<unsigned char>(value[length]) & 0xC0U) == 0x80U) {
            --length;
        }
        return problem(
            name_, line,
            fmt::format("column {}: '{}{}': {}", fields_.size() + 1, value.substr(0, length),
                        length < value.size() ? "..." : "", what));
    }

    std::string_view plain() {
        const std::size_t begin = at_;
        for (; at_ < text_.size(); ++at_) {
            const char letter = text_[at_];
            if (letter > ',') continue;  // beyond all that ends a field
            if (letter == ',' || letter == '\n' || (letter == '\r' && at_line_end())) break;
            if (letter == '"')
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
            line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                                 text_.begin() + static_cast<std::ptrdiff_t>(quote),
                                                 '\n'));
            at_ = quote + 1;
            if (at_line_end() || text_[at_] == ',') {
                return copy == nullptr ? part : std::string_view(copy->append(part));
            }
            if (text_[at_] != '"')
                throw at_field(line_, opening,
                               "text after a closing quote, allowed is a comma or the line's end");
            if (copy == nullptr) copy = &unquoted_.emplace_back();
            copy->append(part);
            begin = at_++;  // the second of two quotes stands for one
        }
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::vector<std::string_view> fields_;
    std::deque<std::string> unquoted_;  // which does not move what it holds
};

/// Text that comes in pieces: what ends with a record is given on, the rest waits.
class Pieces {
  public:
    /// Adds to the text; the part that can be read now, which the next call drops.
    std::string_view add(std::string_view piece) {
        waiting_.erase(0, given_);
        scanned_ -= given_;
        waiting_ += piece;
        given_ = 0;
        // From quote to quote, of which a large file has few.
        while (scanned_ < waiting_.size()) {
            const std::size_t end = std::min(waiting_.find('"', scanned_), waiting_.size());
            if (!in_quotes_ && end > scanned_) {
                const std::size_t line_end = waiting_.rfind('\n', end - 1);
                if (line_end != std::string::npos && line_end >= scanned_) given_ = line_end + 1;
            }
            if (end < waiting_.size()) in_quotes_ = !in_quotes_;
            scanned_ = end + 1;
        }
        scanned_ = waiting_.size();
        return std::string_view(waiting_).substr(0, given_);
    }
    [[nodiscard]] std::string_view rest() const {
        return std::string_view(waiting_).substr(given_);
    }

  private:
    std::string waiting_;
    std::size_t given_ = 0;
    std::size_t scanned_ = 0;
    bool in_quotes_ = false;
};

std::string_view without_mark(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    return text;
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
    for_each_csv_row(text, name, [&](const CsvRow& row) {
        take({row.line, std::vector<std::string>(row.fields.begin(), row.fields.end())});
    });
}

void for_each_csv_row(std::string_view text, const std::string& name,
                      const std::function<void(const CsvRow&)>& take) {
    Parser(name).run(without_mark(text), take);
}

void for_each_csv_row(const std::filesystem::path& file,
                      const std::function<void(const CsvRow&)>& take) {
    const std::string name = file.string();
    std::error_code ignored;
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file, ignored)) {
        (void)base::read_file(file);  // says why
        throw base::bad_input("{}: cannot be read", name);
    }
    constexpr std::size_t kPiece = std::size_t{4} << 20U;
    std::string piece(kPiece, '\0');
    Parser parser(name);
    Pieces pieces;
    bool is_first = true;
    do {
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        std::string_view text(piece.data(), static_cast<std::size_t>(stream.gcount()));
        if (is_first) text = without_mark(text);
        is_first = false;
        parser.run(pieces.add(text), take);
    } while (stream);
    if (stream.bad()) throw base::bad_input("{}: cannot be read to its end", name);
    parser.run(pieces.rest(), take);
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
