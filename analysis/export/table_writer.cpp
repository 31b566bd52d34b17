// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/table_writer.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace obscura::analysis {
namespace {

/// The characters for which a field is quoted.
class Special {
  public:
    explicit constexpr Special(std::string_view letters) {
        for (const char letter : letters) is_[static_cast<unsigned char>(letter)] = true;
    }
    [[nodiscard]] bool is_in(std::string_view text) const {
        return std::any_of(text.begin(), text.end(),
                           [this](char letter) { return is_[static_cast<unsigned char>(letter)]; });
    }

  private:
    std::array<bool, 256> is_{};
};
constexpr Special kCsvSpecial(",\"\r\n");
constexpr Special kTsvSpecial("\t\"\r\n");

/// RFC 4180, 2.5 to 2.7.
void quote_where_needed(std::string& line, std::size_t begin, const Special& special) {
    if (!special.is_in(std::string_view(line).substr(begin))) return;
    const std::string text = line.substr(begin);
    line.resize(begin);
    line += '"';
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t quote = std::min(text.find('"', from), text.size() - 1);
        line.append(text, from, quote + 1 - from);
        if (text[quote] == '"') line += '"';
        from = quote + 1;
    }
    line += '"';
}

}  // namespace

std::string_view ending_of(Layout layout) {
    switch (layout) {
        case Layout::kCsv:
            return ".csv";
        case Layout::kTsv:
        case Layout::kBidsTsv:
            return ".tsv";
        case Layout::kJsonLines:
            return ".jsonl";
    }
    return "";
}

std::string json_text(std::string_view text) { return nlohmann::json(text).dump(); }

void finish_cell(std::string& line, std::size_t begin, bool number, Layout layout) {
    const bool known = line.size() > begin;
    switch (layout) {
        case Layout::kCsv:
            if (!number) quote_where_needed(line, begin, kCsvSpecial);
            break;
        case Layout::kTsv:
            if (!number) quote_where_needed(line, begin, kTsvSpecial);
            break;
        case Layout::kBidsTsv:
            if (!known) line += "n/a";
            std::replace_if(
                line.begin() + static_cast<std::ptrdiff_t>(begin), line.end(),
                [](char letter) { return letter == '\t' || letter == '\n' || letter == '\r'; },
                ' ');
            break;
        case Layout::kJsonLines:
            if (!known) {
                line += "null";
            } else if (!number) {
                const std::string text = json_text(std::string_view(line).substr(begin));
                line.replace(begin, std::string::npos, text);
            }
            break;
    }
}

}  // namespace obscura::analysis
