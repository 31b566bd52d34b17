// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_order.h"

namespace obscura::analysis {

OrderReader::OrderReader(const TrialsColumns& columns, FileProblems& problems,
                         NumberReader& numbers)
    : columns_(columns), problems_(problems), numbers_(numbers) {
    if (!columns.has(kOrder) && !columns.has(kFirstShown)) {
        unknown_ = "the file does not say which image was shown first";
    }
}

void OrderReader::read(const CsvRow& row, AnswerEntry& answer) {
    if (columns_.has(kFirstShown)) {
        const std::string_view text = columns_.field(row, kFirstShown);
        const std::string small = lower(text);
        if (small != "a" && small != "b") {
            columns_.report(problems_, row.line, kFirstShown, text, "are A, B");
            return;
        }
        answer.first_shown = small == "a" ? 'A' : 'B';
    }
    if (columns_.has(kOrder)) read_order(row, answer);
}

void OrderReader::read_order(const CsvRow& row, AnswerEntry& answer) {
    const std::string_view text = columns_.field(row, kOrder);
    const std::string small = lower(text);
    const auto number = numbers_.whole(text, kLastIndex);
    const bool is_side = small == "ab" || small == "ba" || small == "a" || small == "b";
    const char first = small.starts_with('a') ? 'A' : 'B';
    if (!is_number_) is_number_ = number.has_value();
    if ((!number && !is_side) || number.has_value() != *is_number_) {
        columns_.report(problems_, row.line, kOrder, text,
                        "are AB, BA, A, B, or in all rows the trial's whole number; --map order= "
                        "passes the column over");
    } else if (number) {
        answer.trial_index = static_cast<std::int32_t>(*number);
        if (!columns_.has(kFirstShown)) {
            unknown_ = "the column order numbers the trials and does not say which image was first";
        }
    } else if (columns_.has(kFirstShown) && first != answer.first_shown) {
        columns_.report(problems_, row.line, kOrder, text, "is what the column first_shown says");
    } else {
        answer.first_shown = first;
    }
}

void OrderReader::check_response(const CsvRow& row, const AnswerEntry& answer) {
    if (!columns_.has(kResponse)) return;
    const std::string_view text = columns_.field(row, kResponse);
    const std::string small = lower(text);
    const bool chose_first = answer.a_selected == (answer.first_shown == 'A');
    if (small != "first" && small != "second") {
        columns_.report(problems_, row.line, kResponse, text, "are first, second");
    } else if (unknown_.empty() && (small == "first") != chose_first) {
        columns_.report(problems_, row.line, kResponse, text,
                        "is what is_A_selected and the order of showing say");
    }
}

}  // namespace obscura::analysis
