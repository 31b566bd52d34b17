// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/form_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/export/member_cells.h"

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

[[nodiscard]] std::vector<std::pair<std::string, std::string>> levels_of(const FormJson& row) {
    std::vector<std::pair<std::string, std::string>> levels;
    for (const FormJson& choice : row.value("choices", FormJson::array())) {
        levels.emplace_back(choice, choice);
    }
    for (const FormJson& level : row.value("levels", FormJson::array())) {
        levels.emplace_back(level.at(0), level.at(1));
    }
    return levels;
}

[[nodiscard]] Column column_of(const std::string& field, const FormJson& row) {
    const std::string kind = row.value("kind", "");
    const bool number = kind == "number" || kind == "scale";
    const bool several = kind == "choices";
    return {"form_" + field,
            fmt::format("Answer to the study's question: {}{}; empty: no answer",
                        row.value("label", ""), several ? " (several, with ; between)" : ""),
            several ? std::vector<std::pair<std::string, std::string>>{} : levels_of(row),
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
