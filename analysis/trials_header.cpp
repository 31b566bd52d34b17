// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_header.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "analysis/export/tables.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr std::size_t kProblemsShown = 100;

bool is_exported(const std::string& name) {
    const auto& columns = trials_export().columns;
    return std::any_of(columns.begin(), columns.end(),
                       [&](const auto& column) { return column.name == name; });
}

/// What a column is called here.
std::string_view name_of(std::string_view field) {
    if (field == kOtherObserver) return kColumnNames[kObserver];
    return field == kOtherResponseTime ? kColumnNames[kResponseTime] : field;
}

}  // namespace

void FileProblems::add(int line, std::string_view what) {
    if (++count_ <= kProblemsShown) lines_.push_back(fmt::format("{}:{}: {}", file_, line, what));
}

void FileProblems::add(int line, TrialsColumn column, std::string_view value,
                       std::string_view allowed) {
    add(line, fmt::format("column {}: '{}', allowed {}", kColumnNames[column], value, allowed));
}

void FileProblems::throw_if_any() const {
    if (count_ == 0) return;
    std::string text = fmt::format("{}", fmt::join(lines_, "\n"));
    if (count_ > kProblemsShown) {
        text += fmt::format("\n{}: and {} more like these", file_, count_ - kProblemsShown);
    }
    throw base::bad_input("{}", text);
}

TrialsHeader::TrialsHeader(const CsvRow& record, FileProblems& problems)
    : width_(record.fields.size()) {
    std::set<std::string> met;
    for (std::size_t i = 0; i < record.fields.size(); ++i) {
        const std::string field(record.fields[i]);
        if (!met.insert(field).second) {
            problems.add(record.line, fmt::format("column '{}' stands there twice", field));
        }
        const auto name =
            std::find(kColumnNames.begin(), kColumnNames.end(), name_of(record.fields[i]));
        if (name != kColumnNames.end()) {
            place_[static_cast<std::size_t>(name - kColumnNames.begin())] = i;
        } else if (!is_exported(field)) {
            problems.add(record.line,
                         fmt::format("unknown column '{}', allowed are {}, {} and the others "
                                     "of the exported trials.csv",
                                     field, kOtherObserver, fmt::join(kColumnNames, ", ")));
        }
    }
    for (const std::string_view other : {kOtherObserver, kOtherResponseTime}) {
        if (!met.contains(std::string(other)) || !met.contains(std::string(name_of(other))))
            continue;
        problems.add(record.line,
                     fmt::format("columns {} and {}, allowed is one", name_of(other), other));
    }
    for (std::size_t column = 0; column < kNeededColumns; ++column) {
        if (place_[column]) continue;
        problems.add(record.line, fmt::format("column {} is missing", kColumnNames[column]));
    }
}

}  // namespace obscura::analysis
