// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_columns.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "analysis/export/tables.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

/// In the order of TrialsColumn. Hints are the names of PsychoPy, jsPsych, OpenSesame, Gorilla,
/// crowd-work sites and published data sets.
const std::array<KnownColumn, kColumnCount>& known_columns() {
    static const std::array<KnownColumn, kColumnCount> columns{{
        {"observer",
         {"participant_id"},
         {"participant", "subject",    "subject_id",   "subject_nr", "subj", "ppn",
          "worker_id",   "worker",     "PROLIFIC_PID", "user_id",    "user", "rater",
          "judge",       "respondent", "sub",          "pp",         "vp",   "vpn",
          "proband",     "pid",        "person",       "name",       "id",   "run_id"}},
        {"condition_A",
         {},
         {"variant_a",      "stimulus_left", "left_stimulus", "image_left",  "left_image",
          "left",           "stimulus_a",    "image_a",       "stimulus[0]", "stimulus_1",
          "image_1",        "stim1",         "option_1",      "item_1",      "method_a",
          "method_1",       "technique_a",   "first",         "first_image", "a",
          "stimulus_first", "img_left",      "img1",          "stim_left",   "stima"}},
        {"condition_B",
         {},
         {"variant_b",       "stimulus_right", "right_stimulus", "image_right",  "right_image",
          "right",           "stimulus_b",     "image_b",        "stimulus[1]",  "stimulus_2",
          "image_2",         "stim2",          "option_2",       "item_2",       "method_b",
          "method_2",        "technique_b",    "second",         "second_image", "b",
          "stimulus_second", "img_right",      "img2",           "stim_right",   "stimb"}},
        {"is_A_selected", {}, {"a_selected", "chose_a", "selected_a", "prefers_a", "a_wins"}},
        {"chose_B", {}, {"b_selected", "selected_b", "is_b_selected", "prefers_b", "b_wins"}},
        {"chosen",
         {},
         {"choice", "response", "selected", "selection", "winner", "preferred", "preference",
          "answer", "picked", "judgement", "judgment", "resp", "key_resp.keys", "decision"}},
        {"session_id", {}, {}},
        {"scene", {}, {}},
        {"order", {}, {}},
        {"condition", {}, {}},
        {"hypothesis", {}, {}},
        {"validity", {}, {}},
        {"first_shown", {}, {}},
        {"response", {}, {}},
        {"trial_index", {}, {}},
        {"kind", {}, {}},
        {"study", {}, {}},
        {"study_A", {}, {}},
        {"session_state", {}, {}},
        {"response_time", {"response_time (s)", "response_time_s"}, {}},
        {"response_time_ms", {}, {"rt"}},
        {"expected", {}, {}},
        {"repeats", {}, {}},
        {"exclusion", {}, {}},
        {"study_plan", {}, {}},
    }};
    return columns;
}

}  // namespace

TrialsColumns::TrialsColumns(const CsvRow& header, const ColumnMap& map, FileProblems& problems)
    : Columns(header, known_columns(), map, problems) {
    if (!problems.none()) return;
    if (!has(kFirstShown)) drop(kResponse);
    bool any_missing = false;
    for (const TrialsColumn column : {kObserver, kConditionA, kConditionB}) {
        if (has(column)) continue;
        report_missing(column, {}, problems);
        any_missing = true;
    }
    if (!has(kIsASelected) && !has(kChoseB) && !has(kChosen)) {
        constexpr std::array<std::size_t, 2> kInstead{kChosen, kChoseB};
        report_missing(kIsASelected, kInstead, problems);
        any_missing = true;
    }
    if (any_missing) report_names(problems);
    if (has(kIsASelected)) drop(kChoseB);
    if (has(kIsASelected) || has(kChoseB)) drop(kChosen);
    if (has(kResponseTime)) drop(kResponseTimeMs);
}

void TrialsColumns::report(FileProblems& problems, int line, TrialsColumn column,
                           std::string_view value, std::string_view allowed) const {
    problems.add(
        line, fmt::format("column {}: '{}', allowed {}", name(column), printable(value), allowed));
}

std::string TrialsColumns::passed_over() const {
    std::vector<std::string_view> exported;
    for (const auto& column : trials_export().columns) {
        if (column.name != known_columns()[kResponse].name) exported.push_back(column.name);
    }
    return Columns::passed_over(exported);
}

}  // namespace obscura::analysis
