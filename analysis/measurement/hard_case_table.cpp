// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/hard_case_table.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/table/csv.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

std::string number(double value) {
    return std::isfinite(value) ? shortest(value) : fmt::format("{}", value);
}

std::string number(const std::optional<double>& value) { return value ? number(*value) : ""; }

}  // namespace

std::optional<double> HardCaseRow::by_nature() const {
    return definition ? std::optional(expected - *definition) : std::nullopt;
}

std::optional<double> HardCaseRow::numerical() const {
    return definition ? std::optional(*definition - measured) : std::nullopt;
}

std::string to_string(Holds holds) {
    switch (holds) {
        case Holds::kYes:
            return "yes";
        case Holds::kByNature:
            return "by nature";
        case Holds::kUndecided:
            return "not decided";
        case Holds::kNo:
            return "no";
    }
    return "";
}

HardCaseCount count_of(const std::vector<HardCaseRow>& rows) {
    HardCaseCount count;
    for (const HardCaseRow& row : rows) {
        ++(row.holds == Holds::kYes         ? count.yes
           : row.holds == Holds::kByNature  ? count.by_nature
           : row.holds == Holds::kUndecided ? count.undecided
                                            : count.no);
        if (row.against != HeldAgainst::kDefinition) continue;
        ++count.numerical;
        if (row.holds == Holds::kYes) ++count.numerical_holding;
    }
    return count;
}

std::string hard_cases_csv(const std::vector<HardCaseRow>& rows) {
    std::string text =
        csv_line({"case", "technique", "quantity", "expected", "measured", "tolerance", "holds",
                  "note", "against", "definition", "by_nature", "numerical"});
    for (const HardCaseRow& row : rows) {
        text +=
            csv_line({row.name, row.technique, row.quantity, number(row.expected),
                      number(row.measured), number(row.tolerance), to_string(row.holds), row.note,
                      row.against == HeldAgainst::kTruth ? "truth" : "definition",
                      number(row.definition), number(row.by_nature()), number(row.numerical())});
    }
    return text;
}

std::string failing_hard_cases(const std::vector<HardCaseRow>& rows) {
    std::string text;
    for (const HardCaseRow& row : rows) {
        if (row.holds != Holds::kNo && row.holds != Holds::kUndecided) continue;
        text += fmt::format("{}: {}{}{}: expected {:g}, measured {:g}, allowed are {:g} off{}\n",
                            row.holds == Holds::kNo ? "fails" : "not decided", row.name,
                            row.technique.empty() ? "" : ", " + row.technique,
                            row.quantity.empty() ? "" : ", " + row.quantity, row.expected,
                            row.measured, row.tolerance, row.note.empty() ? "" : "; " + row.note);
    }
    return text;
}

std::string hard_cases_in_a_sentence(const std::vector<HardCaseRow>& rows) {
    const HardCaseCount count = count_of(rows);
    return fmt::format(
        "{} hard cases: {} hold, {} do not by the nature of the technique, {} {} not decided, {} "
        "do not without a reason. Of {} that hold a shader against its own definition, {} hold.",
        rows.size(), count.yes, count.by_nature, count.undecided,
        count.undecided == 1 ? "is" : "are", count.no, count.numerical, count.numerical_holding);
}

}  // namespace obscura::analysis
