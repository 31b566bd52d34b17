// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/text_layout.h"

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace obscura::analysis {
namespace {

/// Letters on screen: UTF-8 bytes that begin one.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    }));
}

}  // namespace

std::string aligned(const std::vector<TextRow>& rows, std::size_t left) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const TextRow& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], width_of(row[i]));
        }
    }
    std::string text;
    for (const TextRow& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - width_of(row[i]), ' ');
            if (i > 0) line += "  ";
            line += i < left ? row[i] + blanks : blanks + row[i];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

std::string wrapped(const std::string& text) {
    constexpr std::size_t kWidth = 100;
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const std::string indent(line.find_first_not_of(' ') == 2 ? 4 : 2, ' ');
        while (width_of(line) > kWidth) {
            std::size_t end = line.rfind(' ', kWidth);
            if (end == std::string::npos || end < indent.size()) break;
            result += line.substr(0, end) + '\n';
            line = indent + line.substr(end + 1);
        }
        result += line + '\n';
    }
    return result;
}

}  // namespace obscura::analysis
