// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/obj_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace obscura::renderer::import_detail {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

/// Whether the '#' there belongs to a number that is none.
bool is_in_number(std::string_view line, std::size_t hash) {
    if (!line.substr(0, hash).ends_with("1.")) return false;
    constexpr std::array<std::string_view, 4> kWords = {"INF", "IND", "QNAN", "SNAN"};
    return std::any_of(kWords.begin(), kWords.end(), [&](std::string_view word) {
        return line.substr(hash + 1).starts_with(word);
    });
}

std::string_view before_comment(std::string_view line) {
    for (std::size_t at = line.find('#'); at != std::string_view::npos;
         at = line.find('#', at + 1)) {
        if (!is_in_number(line, at)) return line.substr(0, at);
    }
    return line;
}

std::string_view first_word(std::string_view line) {
    line = trimmed(line);
    return line.substr(0, line.find_first_of(kBlanks));
}

bool may_go_on(std::string_view line) {
    const std::string key = lower(first_word(line));
    return !key.starts_with('#') && key != "newmtl" && key != "usemtl";
}

}  // namespace

std::vector<std::string_view> ObjLine::words() const {
    std::string_view left = before_comment(text);
    std::vector<std::string_view> words;
    for (;;) {
        const std::size_t from = left.find_first_not_of(kBlanks);
        if (from == std::string_view::npos) return words;
        left.remove_prefix(from);
        const std::size_t length = std::min(left.find_first_of(kBlanks), left.size());
        words.push_back(left.substr(0, length));
        left.remove_prefix(length);
    }
}

std::string ObjLine::key() const { return lower(first_word(text)); }

std::string_view ObjLine::rest() const {
    const std::string_view line = trimmed(text);
    return trimmed(line.substr(first_word(line).size()));
}

ObjLines::ObjLines(std::string_view text) : rest_(text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kMark)) rest_.remove_prefix(kMark.size());
}

std::string_view ObjLines::take() {
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    const std::size_t mark = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
    rest_.remove_prefix(std::min(end + mark, rest_.size()));
    ++taken_;
    return line;
}

bool ObjLines::next(ObjLine& line) {
    while (!rest_.empty()) {
        line.text = take();
        line.number = taken_;
        const bool goes_on = may_go_on(line.text);
        while (goes_on && line.text.ends_with('\\') && !rest_.empty()) {
            line.text.back() = ' ';
            line.text += take();
        }
        const std::string_view word = first_word(line.text);
        if (!word.empty() && word.front() != '#') return true;
    }
    return false;
}

bool parse_number(std::string_view word, double& value) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, value);
    if (rest != end || word.empty()) return false;
    // Too large, or so small that it is nothing.
    if (error == std::errc::result_out_of_range)
        value = std::strtod(std::string(word).c_str(), nullptr);
    return (error == std::errc() || error == std::errc::result_out_of_range) &&
           std::isfinite(value);
}

std::string lower(std::string_view word) {
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(kBlanks);
    if (from == std::string_view::npos) return {};
    return text.substr(from, text.find_last_not_of(kBlanks) + 1 - from);
}

std::string_view without_comment(std::string_view name) {
    for (std::size_t at = name.find('#', 1); at != std::string_view::npos;
         at = name.find('#', at + 1)) {
        if (kBlanks.find(name[at - 1]) != std::string_view::npos) {
            return trimmed(name.substr(0, at));
        }
    }
    return name;
}

std::string_view without_quotes(std::string_view name) {
    const bool quoted = name.size() > 2 && name.front() == name.back() &&
                        (name.front() == '"' || name.front() == '\'');
    return quoted ? name.substr(1, name.size() - 2) : name;
}

}  // namespace obscura::renderer::import_detail
