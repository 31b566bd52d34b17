// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/table/values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace obscura::analysis {
namespace {

/// What people's programs put round values and nobody sees.
constexpr std::array<std::string_view, 6> kBlanks{" ",  "\t",       "\n",
                                                  "\r", "\xC2\xA0", "\xEF\xBB\xBF"};

template <std::size_t kCount>
bool is_one_of(std::string_view text, const std::array<std::string_view, kCount>& words) {
    constexpr std::size_t kLongest = 9;  // of all such words: no need to look at longer text
    if (text.size() > kLongest) return false;
    const std::string small = lower(text);
    return std::find(words.begin(), words.end(), small) != words.end();
}

constexpr std::array<std::string_view, 7> kMissingNames{"na",   "n/a",       "#n/a", "nan",
                                                        "null", "undefined", "<na>"};
constexpr std::array<std::string_view, 6> kMissing{"none", "nil", "missing", ".", "-", "--"};

}  // namespace

std::string_view trimmed(std::string_view text) {
    const auto is_inner = [](char letter) {
        // Most text begins and ends with such a letter.
        return letter > ' ' && static_cast<unsigned char>(letter) < 0x80U;
    };
    bool again = !text.empty() && !(is_inner(text.front()) && is_inner(text.back()));
    while (again) {
        again = false;
        for (const std::string_view blank : kBlanks) {
            if (text.starts_with(blank)) {
                text.remove_prefix(blank.size());
                again = true;
            }
            if (text.ends_with(blank)) {
                text.remove_suffix(blank.size());
                again = true;
            }
        }
    }
    return text;
}

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& letter : small) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return small;
}

bool is_missing_name(std::string_view text) {
    return text.empty() || is_one_of(text, kMissingNames);
}

bool is_missing(std::string_view text) {
    return is_missing_name(text) || is_one_of(text, kMissing);
}

std::optional<bool> truth(std::string_view text) {
    if (text == "1") return true;
    if (text == "0") return false;
    // The later ones are those of spreadsheets in German, French, Spanish, Italian and Dutch.
    constexpr std::array<std::string_view, 9> kTrue{"true", "t",         "yes",  "y",   "wahr",
                                                    "vrai", "verdadero", "vero", "waar"};
    constexpr std::array<std::string_view, 8> kFalse{"false",  "f",    "no",    "n",
                                                     "falsch", "faux", "falso", "onwaar"};
    if (is_one_of(text, kTrue)) return true;
    if (is_one_of(text, kFalse)) return false;
    const auto number = NumberReader(true).whole(text, 1);
    if (!number) return std::nullopt;
    return *number == 1;
}

std::optional<double> NumberReader::number(std::string_view text) {
    std::string with_point;
    if (const auto comma = text.find(','); comma != std::string_view::npos) {
        if (!may_ || has_point_ || text.find_first_of(".,", comma + 1) != std::string_view::npos ||
            text.find('.') < comma) {
            return std::nullopt;
        }
        has_comma_ = true;
        with_point = text;
        with_point[comma] = '.';
        text = with_point;
    } else if (text.find('.') != std::string_view::npos) {
        if (has_comma_) return std::nullopt;
        has_point_ = true;
    }
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [next, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || next != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::int64_t> NumberReader::whole(std::string_view text, std::int64_t most) {
    std::int64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [next, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && next == end) {
        if (value < 0 || value > most) return std::nullopt;
        return value;
    }
    const auto real = number(text);
    if (!real || *real < 0.0 || *real > static_cast<double>(most) || std::floor(*real) != *real) {
        return std::nullopt;
    }
    return static_cast<std::int64_t>(*real);
}

}  // namespace obscura::analysis
