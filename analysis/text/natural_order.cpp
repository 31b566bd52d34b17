// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/text/natural_order.h"

#include <cctype>

namespace obscura::analysis {

bool naturally_before(std::string_view one, std::string_view other) {
    const auto is_digit = [](char letter) {
        return std::isdigit(static_cast<unsigned char>(letter)) != 0;
    };
    const auto take_run = [&](std::string_view& text) {
        const bool digits = is_digit(text.front());
        std::size_t length = 1;
        while (digits && length < text.size() && is_digit(text[length])) ++length;
        const std::string_view run = text.substr(0, length);
        text.remove_prefix(length);
        return run;
    };
    while (!one.empty() && !other.empty()) {
        const std::string_view a = take_run(one);
        const std::string_view b = take_run(other);
        if (a == b) continue;
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    }
    return one.size() < other.size();
}

}  // namespace obscura::analysis
