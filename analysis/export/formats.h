// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/export/export_folder.h"
#include "analysis/export/source.h"
#include "analysis/export/table_writer.h"

namespace obscura::analysis {

/// What each kind of export is made with.
struct ExportJob {
    const ExportOptions& options;
    ExportSource& source;
    ExportFolder& folder;
    Exported& exported;
};

// One function for each kind of export, which adds all of its files to the folder.
void export_tables(const ExportJob& job);  ///< csv, tsv, json
void export_bids(const ExportJob& job);
void export_psych_ds(const ExportJob& job);

/// Study files, manifests and images, as FOLDER/STUDY/study.toml, manifest.json and
/// CONDITION-a.png. Throws bad input for an image whose bytes are not those of the manifest.
void add_studies(const ExportJob& job, const std::string& folder);

/// Adds main_tests.R and main_tests.py, in `folder` (empty: at the top), which find the tables.
void add_scripts(const ExportJob& job, const std::string& folder);

/// Writes the rows that `each` gives, as the file NAME + the layout's ending.
template <typename Row, typename Each>
void write_table(const ExportJob& job, const std::string& name,
                 const std::vector<ExportColumn<Row>>& columns, Layout layout, const Each& each) {
    OutputFile file(job.folder.add(name + std::string(ending_of(layout))));
    TableWriter<Row> writer(columns, layout, file);
    each([&](const Row& row) { writer.write(row); });
    file.close();
}

/// The columns' entries in a data dictionary (BIDS 1.9, "Tabular files").
template <typename Row>
[[nodiscard]] nlohmann::ordered_json described(const std::vector<ExportColumn<Row>>& columns) {
    nlohmann::ordered_json entries = nlohmann::ordered_json::object();
    for (const auto& column : columns) {
        auto& entry = entries[column.name];
        entry["Description"] = column.description;
        for (const auto& [value, meaning] : column.levels) entry["Levels"][value] = meaning;
        if (!column.units.empty()) entry["Units"] = column.units;
    }
    return entries;
}

/// Sentences that a reader of any export needs: what it is, what is not in it.
[[nodiscard]] std::string readme_text(const ExportJob& job);

}  // namespace obscura::analysis
