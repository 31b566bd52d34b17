// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/text/text.h"

#include <fmt/format.h>
#include <utf8.h>

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace obscura::analysis {

bool is_utf8(std::string_view text) { return utf8::is_valid(text.begin(), text.end()); }

namespace {

/// A letter as a message may show it; a byte that is none where `code` is no letter.
void append_printable(std::string& shown, std::string_view letter, std::uint32_t code) {
    // C0, DEL and C1 (Unicode, category Cc).
    const bool is_control = code < 0x20U || (code >= 0x7FU && code < 0xA0U);
    if (code == '\n' || code == '\r' || code == '\t') {
        shown += code == '\n' ? "\\n" : code == '\r' ? "\\r" : "\\t";
    } else if (is_control) {
        shown += fmt::format("\\x{:02x}", code);
    } else {
        shown += letter;
    }
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
    std::string shown;
    for (std::size_t begin = 0; begin < text.size();) {
        const char* const letter = text.data() + begin;
        const char* end = letter;
        std::uint32_t code = 0;
        std::string byte;
        try {
            code = utf8::next(end, text.data() + text.size());
        } catch (const utf8::exception&) {
            end = letter + 1;
            byte = fmt::format("\\x{:02x}", static_cast<unsigned char>(*letter));
        }
        begin = static_cast<std::size_t>(end - text.data());
        if (begin > most) return shown + "...";
        if (byte.empty()) {
            append_printable(shown, {letter, end}, code);
        } else {
            shown += byte;
        }
    }
    return shown;
}

std::string shortest(double value) {
    std::string text;
    append_shortest(text, value);
    return text;
}

void append_shortest(std::string& text, double value) {
    assert(std::isfinite(value));
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end.ptr);
}

std::string html_escaped(std::string_view text) {
    std::string escaped;
    for (const char letter : text) {
        switch (letter) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += letter;
        }
    }
    return escaped;
}

}  // namespace obscura::analysis
