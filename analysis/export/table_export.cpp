// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/condition_counter.h"
#include "analysis/export/form_columns.h"
#include "analysis/export/formats.h"
#include "analysis/export/question_table.h"

namespace obscura::analysis {
namespace {

Layout layout_of(ExportFormat format) {
    switch (format) {
        case ExportFormat::kTsv:
            return Layout::kTsv;
        case ExportFormat::kJsonLines:
            return Layout::kJsonLines;
        default:
            return Layout::kCsv;
    }
}

}  // namespace

void export_tables(const ExportJob& job) {
    const Layout layout = layout_of(job.options.format);
    ExportSource& source = job.source;
    nlohmann::ordered_json dictionary;
    const auto write = [&](const auto& table, const auto& each) {
        const auto columns = source.columns(table);
        write_table(job, table.name, columns, layout, each);
        dictionary[table.name + std::string(ending_of(layout))] = described(columns);
    };
    write(participants_with_forms(source), [&](const auto& take) {
        source.each_participant([&](const ParticipantRecord& participant) {
            ++job.exported.participants;
            take(participant);
        });
    });
    write(sessions_export(), [&](const auto& take) {
        source.each_session([&](const SessionRow& row) {
            ++job.exported.sessions;
            if (row.session->kind == Kind::kSimulated) ++job.exported.simulated;
            take(row);
        });
    });
    ConditionCounter conditions;
    write(trials_with_ties(source), [&](const auto& take) {
        source.each_trial(
            [&](const TrialRow& row) {
                conditions.add(*row.trial, *row.session);
                take(row);
            },
            job.exported);
    });
    if (source.has_questions()) {
        write(answers_export(source), [&](const auto& take) {
            source.each_answer([&](const QuestionAnswer& answer, const SessionRecord& session) {
                take(QuestionRow{&answer, &session});
            });
        });
    }
    write(conditions_export(), [&](const auto& take) {
        for (const ConditionRow& row : conditions.rows()) take(row);
    });
    write(events_export(), [&](const auto& take) { source.each_event(take); });
    write(tests_export(), [&](const auto& take) {
        for (const ExportedTest& row : job.options.tests) take(row);
    });
    job.folder.add("data_dictionary.json", dictionary.dump(2) + '\n');
    add_studies(job, "stimuli");
    add_scripts(job, "");
}

}  // namespace obscura::analysis
