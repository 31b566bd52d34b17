// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Psych-DS 1.0 (psych-ds.github.io): a dataset_description.json in JSON-LD with schema.org's words,
// and tables data/KEYWORD-VALUE_data.csv whose every column is in variableMeasured.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/export/condition_counter.h"
#include "analysis/export/form_columns.h"
#include "analysis/export/formats.h"
#include "analysis/export/question_table.h"

namespace obscura::analysis {
namespace {

using Json = nlohmann::ordered_json;

/// Adds a table's columns to the variables; one that several tables have keeps what each says.
template <typename Row>
void add_variables(Json& variables, const std::vector<ExportColumn<Row>>& columns) {
    for (const auto& column : columns) {
        auto known = std::find_if(variables.begin(), variables.end(), [&](const Json& variable) {
            return variable["name"] == column.name;
        });
        if (known == variables.end()) {
            variables.push_back({{"@type", "PropertyValue"},
                                 {"name", column.name},
                                 {"description", column.description}});
            known = variables.end() - 1;
            if (!column.units.empty()) (*known)["unitText"] = column.units;
        } else {
            const auto said = (*known)["description"].template get<std::string>();
            if (said.find(column.description) == std::string::npos) {
                (*known)["description"] = said + "; " + column.description;
            }
        }
        for (const auto& [value, meaning] : column.levels) {
            const Json level = {
                {"@type", "PropertyValue"}, {"value", value}, {"description", meaning}};
            Json& levels = (*known)["valueReference"];
            const bool same = std::any_of(levels.begin(), levels.end(), [&](const Json& other) {
                return other["value"] == value;
            });
            if (!same) levels.push_back(level);
        }
    }
}

/// A table with its rows numbered in the column row_id.
template <typename Row>
std::vector<ExportColumn<Row>> with_row_id(std::vector<ExportColumn<Row>> columns,
                                           std::size_t& number) {
    const auto count = [&number](const Row&, std::string& out) { out += std::to_string(++number); };
    columns.insert(columns.begin(),
                   {"row_id", "Number of the row in its file, from 1", {}, "", {count, true}});
    return columns;
}

class PsychDsExport {
  public:
    explicit PsychDsExport(const ExportJob& job) : job_(job) {}

    void run() {
        write(participants_with_forms(job_.source), [&](const auto& take) {
            job_.source.each_participant([&](const ParticipantRecord& participant) {
                ++job_.exported.participants;
                take(participant);
            });
        });
        write(sessions_export(), [&](const auto& take) {
            job_.source.each_session([&](const SessionRow& row) {
                ++job_.exported.sessions;
                if (row.session->kind == Kind::kSimulated) ++job_.exported.simulated;
                studies_[row.session->study];
                take(row);
            });
        });
        write(trials_with_ties(job_.source), [&](const auto& take) {
            job_.source.each_trial(
                [&](const TrialRow& row) {
                    conditions_.add(*row.trial, *row.session);
                    take(row);
                },
                job_.exported);
        });
        if (job_.source.has_questions()) {
            write(answers_export(job_.source), [&](const auto& take) {
                job_.source.each_answer(
                    [&](const QuestionAnswer& answer, const SessionRecord& session) {
                        take(QuestionRow{&answer, &session});
                    });
            });
        }
        write(conditions_export(), [&](const auto& take) {
            for (const ConditionRow& row : conditions_.rows()) take(row);
        });
        write(events_export(), [&](const auto& take) { job_.source.each_event(take); });
        write(tests_export(), [&](const auto& take) {
            for (const ExportedTest& row : job_.options.tests) take(row);
        });
        write_description();
        job_.folder.add("README.md", readme_text(job_));
        add_studies(job_, "materials");
        add_scripts(job_, "analysis/");
    }

  private:
    template <typename Row, typename Each>
    void write(const ExportTable<Row>& table, const Each& each) {
        std::size_t number = 0;
        const auto columns = with_row_id<Row>(job_.source.columns(table), number);
        write_table(job_, fmt::format("data/description-{}_data", table.name), columns,
                    Layout::kCsv, each);
        add_variables(variables_, columns);
    }

    void write_description() {
        std::string names;
        for (const auto& [study, ignored] : studies_) names += (names.empty() ? "" : ", ") + study;
        const std::string name = names.empty() ? "obscura" : names;
        const Json json = {
            {"@context", "https://schema.org/"},
            {"@type", "Dataset"},
            {"name", name},
            {"description",
             fmt::format("Answers to pairs of images that differ only in their ambient occlusion; "
                         "study {}. Tables: participants, sessions, trials (a row an answer), "
                         "conditions (votes), events, tests.",
                         name)},
            {"variableMeasured", variables_}};
        job_.folder.add("dataset_description.json", json.dump(2) + '\n');
    }

    const ExportJob& job_;
    ConditionCounter conditions_;
    std::map<std::string, int> studies_;
    Json variables_ = Json::array();
};

}  // namespace

void export_psych_ds(const ExportJob& job) { PsychDsExport(job).run(); }

}  // namespace obscura::analysis
