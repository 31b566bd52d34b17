// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/html_table.h"
#include "analysis/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace obscura::analysis {
namespace {

bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

/// A cell that says there is no value.
bool is_blank(const std::string& cell) { return cell.empty() || cell == "-" || cell == "–"; }

/// Numbers, counts such as 18 : 18 and intervals such as 0.34 to 0.66.
bool is_number(std::string_view cell) {
    constexpr std::array<std::string_view, 4> kWords{" to ", "10^", "−", "×"};
    bool has_digit = false;
    while (!cell.empty()) {
        const auto word = std::find_if(kWords.begin(), kWords.end(), [&](std::string_view known) {
            return cell.starts_with(known);
        });
        if (word == kWords.end() &&
            std::string_view("0123456789+-.,:<>% e").find(cell.front()) == std::string_view::npos) {
            return false;
        }
        has_digit |= is_digit(cell.front());
        cell.remove_prefix(word == kWords.end() ? 1 : word->size());
    }
    return has_digit;
}

std::vector<bool> number_columns(const PageTable& table) {
    std::vector<bool> columns(table.headings.size(), false);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto column_is = [&](const auto& row) {
            return is_blank(row[i]) || is_number(row[i]);
        };
        const auto has_one = [&](const auto& row) { return !is_blank(row[i]); };
        columns[i] = std::all_of(table.rows.begin(), table.rows.end(), column_is) &&
                     std::any_of(table.rows.begin(), table.rows.end(), has_one);
    }
    return columns;
}

/// The decimal point of a cell's last number and what follows, "" for a whole number.
std::string_view decimals_of(const std::string& cell) {
    const std::size_t point = cell.find_last_not_of("0123456789");
    if (point == std::string::npos || cell[point] != '.') return "";
    return std::string_view(cell).substr(point);
}

std::string longest_decimals(const PageTable& table, std::size_t column) {
    std::string_view longest;
    for (const auto& row : table.rows) {
        const std::string_view decimals = decimals_of(row[column]);
        if (decimals.size() > longest.size()) longest = decimals;
    }
    return std::string(longest);
}

/// What is missing behind a number to bring its point below the others', as a mark that is drawn
/// but belongs to no text.
std::string padding(const std::string& cell, const std::string& longest) {
    if (cell.empty() || !is_digit(cell.back())) return "";
    const std::size_t have = decimals_of(cell).size();
    if (have >= longest.size()) return "";
    std::string missing = longest.substr(have);
    std::replace_if(missing.begin(), missing.end(), is_digit, '0');
    return fmt::format("<span class=\"pad\" data-pad=\"{}\"></span>", missing);
}

std::string html_rows(const PageTable& table, const std::vector<bool>& numbers) {
    std::vector<std::string> longest;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        longest.push_back(numbers[i] ? longest_decimals(table, i) : "");
    }
    std::string html;
    for (const auto& row : table.rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string text = html_escaped(row[i]);
            if (i == 0 && !numbers[i]) {
                html += fmt::format("<th scope=\"row\">{}</th>", text);
            } else if (numbers[i]) {
                html += fmt::format("<td class=\"n\">{}{}</td>", text, padding(row[i], longest[i]));
            } else {
                html += fmt::format("<td>{}</td>", text);
            }
        }
        html += "</tr>\n";
    }
    return html;
}

}  // namespace

std::string html_table(const PageTable& table, std::string_view caption) {
    const std::vector<bool> numbers = number_columns(table);
    std::string html = "<div class=\"table\"><table>\n";
    if (!caption.empty()) html += fmt::format("<caption>{}</caption>\n", html_escaped(caption));
    html += "<thead><tr>";
    for (std::size_t i = 0; i < table.headings.size(); ++i) {
        html += fmt::format("<th scope=\"col\"{}>{}</th>", numbers[i] ? " class=\"n\"" : "",
                            html_escaped(table.headings[i]));
    }
    return html + "</tr></thead>\n<tbody>\n" + html_rows(table, numbers) +
           "</tbody>\n</table></div>\n";
}

std::string markdown_table(const PageTable& table, std::string_view caption) {
    const std::vector<bool> numbers = number_columns(table);
    std::string text = "|";
    for (const std::string& heading : table.headings) {
        text += ' ' + markdown_escaped(heading) + " |";
    }
    text += "\n|";
    for (const bool is_right : numbers) text += is_right ? " ---: |" : " --- |";
    text += '\n';
    for (const auto& row : table.rows) {
        text += '|';
        for (const std::string& cell : row) text += ' ' + markdown_escaped(cell) + " |";
        text += '\n';
    }
    text += '\n';
    if (!caption.empty()) text += fmt::format("*{}*\n\n", markdown_escaped(caption));
    return text;
}

std::string markdown_escaped(std::string_view text) {
    std::string escaped;
    for (const char letter : text) {
        if (std::string_view("\\`*_[]<>|#").find(letter) != std::string_view::npos) escaped += '\\';
        escaped += letter == '\n' ? ' ' : letter;
    }
    return escaped;
}

}  // namespace obscura::analysis
