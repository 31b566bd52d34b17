// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/table/values.h"

namespace obscura::analysis {
namespace {

/// What two names differ in: `1` and `2` of stimulus_1 and stimulus_2.
std::pair<std::string, std::string> difference(std::string one, std::string other) {
    const auto [a, b] = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
    one.erase(one.begin(), a);
    other.erase(other.begin(), b);
    while (!one.empty() && !other.empty() && one.back() == other.back()) {
        one.pop_back();
        other.pop_back();
    }
    return {one, other};
}

bool has(const std::string& name, std::string_view word) {
    return name.find(word) != std::string::npos;
}

/// left for ArrowLeft and left_arrow.
std::string label_of(std::string_view value) {
    std::string label = bare_name(value);
    for (const std::string_view side : {"left", "right"}) {
        if (label == fmt::format("arrow{}", side) || label == fmt::format("{}arrow", side)) {
            return std::string(side);
        }
    }
    return label;
}

}  // namespace

ChoiceReader::ChoiceReader(const TrialsColumns& columns, FileProblems& problems)
    : columns_(columns),
      problems_(problems),
      column_(columns.has(kIsASelected) ? kIsASelected
              : columns.has(kChoseB)    ? kChoseB
                                        : kChosen) {
    if (column_ == kChosen) read_labels();
}

void ChoiceReader::read_labels() {
    const std::string a = bare_name(columns_.name(kConditionA));
    const std::string b = bare_name(columns_.name(kConditionB));
    constexpr std::array<std::pair<const char*, const char*>, 2> kWords{
        {{"left", "right"}, {"first", "second"}}};
    for (const auto& [one, other] : kWords) {
        if (has(a, one) && has(b, other)) labels_.insert({{one, true}, {other, false}});
        if (has(a, other) && has(b, one)) labels_.insert({{one, false}, {other, true}});
    }
    const auto differing = difference(a, b);
    const bool crossed = differing == std::pair<std::string, std::string>("b", "a");
    labels_.insert({{"a", !crossed}, {"b", crossed}});
    if (differing == std::pair<std::string, std::string>("0", "1")) first_number_ = 0;
    if (differing == std::pair<std::string, std::string>("1", "0")) first_number_ = 0;
    first_number_is_a_ = differing != std::pair<std::string, std::string>("1", "0") &&
                         differing != std::pair<std::string, std::string>("2", "1");
}

bool ChoiceReader::is_answered(const CsvRow& row) const {
    const std::string_view value = columns_.field(row, column_);
    if (!is_missing(value)) return true;
    // None may be a variant's name, as that of ours without ambient occlusion.
    return column_ == kChosen && named_variant(row, value).has_value();
}

bool ChoiceReader::is_a_chosen(const CsvRow& row, char first_shown) {
    if (column_ != kChosen) return from_yes_or_no(row);
    line_ = row.line;
    const std::string_view value = columns_.field(row, kChosen);
    const std::optional<bool> named = named_variant(row, value);
    const std::optional<bool> label = labelled(value, first_shown);
    if (named && label && *named != *label) {
        columns_.report(problems_, row.line, kChosen, value,
                        "is what cannot be both a variant's name and the other one's place");
    } else if (!named && !label) {
        columns_.report(problems_, row.line, kChosen, value, allowed());
    }
    return named.value_or(label.value_or(false));
}

bool ChoiceReader::from_yes_or_no(const CsvRow& row) {
    const std::string_view value = columns_.field(row, column_);
    const std::optional<bool> yes = truth(value);
    if (!yes) {
        std::string allowed = "are 0, 1, true, false and the like";
        const std::string label = label_of(value);
        if (named_variant(row, value) || label == "a" || label == "b" || label == "left" ||
            label == "right" || label == "first" || label == "second") {
            allowed += fmt::format("; where it says which one was chosen: {}",
                                   map_option("chosen", columns_.name(column_)));
        }
        columns_.report(problems_, row.line, column_, value, allowed);
    }
    return yes.value_or(false) == (column_ == kIsASelected);
}

std::optional<bool> ChoiceReader::named_variant(const CsvRow& row, std::string_view value) const {
    const std::string_view a = columns_.field(row, kConditionA);
    const std::string_view b = columns_.field(row, kConditionB);
    if (a == b || value.empty()) return std::nullopt;
    if (value == a || value == b) return value == a;
    const std::string small = lower(value);
    const bool is_a = small == lower(a);
    const bool is_b = small == lower(b);
    if (is_a == is_b) return std::nullopt;
    return is_a;
}

std::optional<bool> ChoiceReader::labelled(std::string_view value, char first_shown) {
    const std::string label = label_of(value);
    if (const auto known = labels_.find(label); known != labels_.end()) return known->second;
    if (first_shown != 0 && (label == "first" || label == "second")) {
        return (label == "first") == (first_shown == 'A');
    }
    return numbered(value);
}

std::optional<bool> ChoiceReader::numbered(std::string_view value) {
    const auto number = NumberReader(true).whole(value, 2);
    if (!number) return std::nullopt;
    number_lines_.at(static_cast<std::size_t>(*number)) = line_;
    const std::int64_t place = *number - first_number_;
    if (place < 0 || place > 1) return std::nullopt;
    return (place == 0) == first_number_is_a_;
}

std::string ChoiceReader::allowed() const {
    std::string text = "are a variant's name, A, B";
    for (const int number : {first_number_, first_number_ + 1}) {
        text += fmt::format(", {}", number);
    }
    for (const char* label : {"left", "right", "first", "second"}) {
        if (labels_.contains(label)) text += fmt::format(", {}", label);
    }
    return fmt::format(
        "{}; where it is 0 or 1, {} if 1 means A, {} if 1 means B; left and right are clear where "
        "the columns of the variants are called so",
        text, map_option("is_A_selected", columns_.name(kChosen)),
        map_option("chose_B", columns_.name(kChosen)));
}

void ChoiceReader::finish() {
    const auto& [zeros, ones, twos] = number_lines_;
    const bool only_ones = ones != 0 && zeros == 0 && twos == 0;
    if (!only_ones) return;
    problems_.add(ones, fmt::format("column {} has no number but 1, which may count from 0 or from "
                                    "1: {} if it means A, {} if it means B",
                                    columns_.name(kChosen),
                                    map_option("is_A_selected", columns_.name(kChosen)),
                                    map_option("chose_B", columns_.name(kChosen))));
}

}  // namespace obscura::analysis
