// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_fields.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/table/values.h"

namespace obscura::analysis {
namespace {

bool is_control(char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code < 0x20U || code == 0x7FU;
}

}  // namespace

std::uint32_t TrialFields::number_of(const CsvRow& row, TrialsColumn column) {
    const std::string_view text = field(row, column);
    std::uint32_t& last = last_[column];  // most rows repeat what the row before says
    if (table_.names[last] == text) return last;
    if (is_missing_name(text)) return 0;
    const std::size_t known = table_.names.size();
    last = table_.names.number_of(text);
    if (last >= known) check_name(row, column, text);
    return last;
}

void TrialFields::check_name(const CsvRow& row, TrialsColumn column, std::string_view text) {
    const std::size_t kLongestName = column == kStudyPlan ? 100'000 : 1000;
    if (std::any_of(text.begin(), text.end(), is_control)) {
        report(row, column, text, "is text without control characters");
    } else if (text.size() > kLongestName) {
        report(row, column, text, fmt::format("are {} bytes, not {}", kLongestName, text.size()));
    }
}

std::uint32_t TrialFields::needed(const CsvRow& row, TrialsColumn column) {
    const std::uint32_t number = number_of(row, column);
    if (number == 0) {
        problems_.add(row.line, fmt::format("column {} is empty", columns_.name(column)));
    }
    return number;
}

}  // namespace obscura::analysis
