// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/latex.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "analysis/text/embedded.h"

namespace obscura::analysis {
namespace {

/// What LaTeX would take for a command, and what its usual fonts lack.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kEscapes{{
    {"\\", "\\textbackslash{}"},
    {"%", "\\%"},
    {"&", "\\&"},
    {"$", "\\$"},
    {"#", "\\#"},
    {"_", "\\_"},
    {"{", "\\{"},
    {"}", "\\}"},
    {"~", "\\textasciitilde{}"},
    {"^", "\\textasciicircum{}"},
    {"<", "$<$"},
    {">", "$>$"},
    {"|", "\\textbar{}"},
    {"\"", "\\textquotedbl{}"},
    {"\u00a0", "~"},
    {"\u2013", "--"},
    {"\u201c", "``"},
    {"\u201d", "''"},
}};

/// `@key; @other]` after its bracket as `key,other`; empty where it is no citation. `size` is how
/// much of the text that is.
std::string citation_at(std::string_view text, std::size_t& size) {
    size = text.find(']');
    if (!text.starts_with('@') || size == std::string_view::npos) return "";
    std::string keys;
    for (const char letter : text.substr(0, size)) {
        if (letter == ';') keys += ',';
        if (letter != '@' && letter != ';' && letter != ' ') keys += letter;
    }
    ++size;
    return keys;
}

/// Whether a hyphen stands before a number, and is no range or word's.
bool is_minus(std::string_view before, std::string_view text) {
    const bool is_first = before.empty() || before.back() == ' ' || before.back() == '(';
    return is_first && text.size() > 1 && text[0] == '-' && text[1] >= '0' && text[1] <= '9';
}

}  // namespace

std::string latex_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        if (text.front() == '[') {
            std::size_t size = 0;
            if (const std::string keys = citation_at(text.substr(1), size); !keys.empty()) {
                result += fmt::format("\\cite{{{}}}", keys);
                text.remove_prefix(1 + size);
                continue;
            }
        }
        if (is_minus(result, text)) {
            result += "$-$";
            text.remove_prefix(1);
            continue;
        }
        bool is_special = false;
        for (const auto& [special, escape] : kEscapes) {
            if (!text.starts_with(special)) continue;
            result += escape;
            text.remove_prefix(special.size());
            is_special = true;
            break;
        }
        if (is_special) continue;
        result += text.front();
        text.remove_prefix(1);
    }
    return result;
}

std::string latex_table(const PageTable& table, std::string_view caption, std::string_view label) {
    const auto line = [](const std::vector<std::string>& cells) {
        std::string text;
        for (const std::string& cell : cells) {
            text += (text.empty() ? "    " : " & ") + latex_text(cell);
        }
        return text + " \\\\\n";
    };
    std::string rows;
    for (const auto& row : table.rows) rows += line(row);
    // graphicx makes a table that is wider than the page's column as narrow as that, and no other.
    return fmt::format(
        "\\begin{{table}}\n  \\centering\n  \\caption{{{}}}\n  \\label{{{}}}\n  \\footnotesize\n"
        "  \\resizebox{{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}}{{!}}{{%\n"
        "  \\begin{{tabular}}{{{}}}\n    \\toprule\n{}    \\midrule\n{}    \\bottomrule\n"
        "  \\end{{tabular}}}}\n\\end{{table}}\n",
        latex_text(caption), label, std::string(table.headings.size(), 'l'), line(table.headings),
        rows);
}

std::string cited_entries(std::string_view text) {
    std::string cited;
    std::string_view entries = embedded("presentation/references.bib");
    while (!entries.empty()) {
        const std::size_t end = entries.find("\n}\n");
        if (end == std::string_view::npos) break;
        const std::string_view entry = entries.substr(0, end + 3);
        const std::size_t key = entry.find('{') + 1;
        const std::string name = '@' + std::string(entry.substr(key, entry.find(',') - key));
        if (text.find(name) != std::string_view::npos) cited += entry;
        entries.remove_prefix(end + 3);
    }
    return cited;
}

}  // namespace obscura::analysis
