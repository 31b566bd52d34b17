// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/form_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "analysis/export/member_cells.h"
#include "analysis/export/table_words.h"

namespace obscura::analysis {
namespace {

using Column = ExportColumn<ParticipantRecord>;
using FormJson = nlohmann::ordered_json;

void append_value(const FormJson& value, std::string& out) {
    if (value.is_string()) out += value.get<std::string>();
    if (value.is_number_integer()) append_cell(out, value.get<std::int64_t>());
    if (value.is_number_float()) append_shortest(out, value.get<double>());
    if (!value.is_array()) return;
    std::string separator;
    for (const FormJson& one : value) {
        out += std::exchange(separator, "; ") + one.get<std::string>();
    }
}

[[nodiscard]] std::optional<int> scale_step(const std::string& text) {
    int step = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, step);
    return error == std::errc() && stopped == end ? std::optional(step) : std::nullopt;
}

/// Every step of a scale whose two ends have words: what a column can hold stands in its levels.
[[nodiscard]] Levels steps_between(const FormJson& ends) {
    constexpr int kMostSteps = 100;
    Levels levels;
    for (const auto& [step, label] : ends.items()) levels.emplace_back(step, label);
    if (levels.size() != 2) return levels;
    const std::optional<int> first = scale_step(levels[0].first);
    const std::optional<int> last = scale_step(levels[1].first);
    if (!first || !last || *last - *first > kMostSteps) return levels;
    const auto end = levels.back();
    levels.pop_back();
    for (int step = *first + 1; step < *last; ++step) {
        levels.emplace_back(std::to_string(step), std::to_string(step));
    }
    levels.push_back(end);
    return levels;
}

[[nodiscard]] Levels levels_of(const FormJson& row) {
    if (row.contains("levels") && row["levels"].is_object()) return steps_between(row["levels"]);
    Levels levels;
    for (const FormJson& choice : row.value("choices", FormJson::array())) {
        levels.emplace_back(choice, choice);
    }
    return levels;
}

/// What of the choices can be together in one cell.
[[nodiscard]] std::string any_of(const Levels& choices) {
    std::string text = " (any of: ";
    std::string separator;
    for (const auto& [choice, meaning] : choices) text += std::exchange(separator, "; ") + choice;
    return text + ')';
}

[[nodiscard]] Column column_of(const std::string& field, const FormJson& row) {
    const std::string kind = row.value("kind", "");
    const bool number = kind == "number" || kind == "scale";
    const bool several = kind == "choices";
    const Levels levels = levels_of(row);
    return {"form_" + field,
            fmt::format("Answer to the study's question: {}{}; empty: no answer",
                        row.value("label", ""), several ? any_of(levels) : ""),
            several ? Levels{} : levels,
            row.value("unit", ""),
            {[field](const ParticipantRecord& participant, std::string& out) {
                 if (participant.form.empty()) return;
                 for (const FormJson& answer : FormJson::parse(participant.form)) {
                     if (answer.value("field", "") == field) append_value(answer.at("value"), out);
                 }
             },
             number},
            true};
}

}  // namespace

ExportTable<ParticipantRecord> participants_with_forms(ExportSource& source) {
    ExportTable<ParticipantRecord> table = participants_export();
    source.each_participant([&](const ParticipantRecord& participant) {
        if (participant.form.empty()) return;
        for (const FormJson& row : FormJson::parse(participant.form)) {
            Column column = column_of(row.value("field", ""), row);
            const bool is_new =
                std::none_of(table.columns.begin(), table.columns.end(),
                             [&](const Column& known) { return known.name == column.name; });
            if (is_new) table.columns.push_back(std::move(column));
        }
    });
    return table;
}

}  // namespace obscura::analysis
