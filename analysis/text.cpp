// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace obscura::analysis {

bool is_utf8(std::string_view text) {
    unsigned char all = 0;
    for (const char byte : text) all |= static_cast<unsigned char>(byte);
    if (all < 0x80U) return true;  // ASCII, as most of a large file is
    try {
        (void)nlohmann::json(text).dump();  // strict: throws at the first ill-formed byte
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
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

}  // namespace obscura::analysis
