// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/csv_export.h"

#include <fmt/ranges.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "analysis/csv.h"
#include "analysis/export/tables.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

template <typename Row>
ExportFile csv_file(const ExportTable<Row>& table, const std::vector<Row>& rows) {
    std::vector<std::string> fields;
    for (const auto& column : table.columns) fields.push_back(column.name);
    ExportFile file{table.file, csv_line(fields)};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < fields.size(); ++i) fields[i] = table.columns[i].cell(row);
        file.bytes += csv_line(fields);
    }
    return file;
}

/// The table's entry in the dictionary (BIDS 1.9, "Tabular files").
template <typename Row>
void describe(Json& dictionary, const ExportTable<Row>& table) {
    Json& entries = dictionary[table.file];
    for (const auto& column : table.columns) {
        Json& entry = entries[column.name];
        entry["Description"] = column.description;
        for (const auto& [value, meaning] : column.levels) entry["Levels"][value] = meaning;
        if (!column.units.empty()) entry["Units"] = column.units;
    }
}

/// A folder that goes away with what is in it.
class PassingFolder {
  public:
    explicit PassingFolder(fs::path path) : path_(std::move(path)) {}
    ~PassingFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// Renames files from a folder to their places; what stood there goes back unless all are kept.
class Placement {
  public:
    Placement(fs::path from, fs::path to) : from_(std::move(from)), to_(std::move(to)) {}
    ~Placement() {
        std::error_code ignored;
        for (const std::string& name : placed_) fs::remove(to_ / name, ignored);
        for (const std::string& name : set_aside_) fs::rename(aside(name), to_ / name, ignored);
    }
    Placement(const Placement&) = delete;
    Placement& operator=(const Placement&) = delete;

    void place(const std::string& name) {
        if (fs::exists(fs::symlink_status(to_ / name))) {
            move(to_ / name, aside(name));
            set_aside_.push_back(name);
        }
        move(from_ / name, to_ / name);
        placed_.push_back(name);
    }
    void keep() {
        placed_.clear();
        set_aside_.clear();
    }

  private:
    [[nodiscard]] fs::path aside(const std::string& name) const {
        return from_ / ("earlier-" + name);
    }
    static void move(const fs::path& from, const fs::path& to) {
        std::error_code error;
        fs::rename(from, to, error);
        if (error) {
            throw base::failure("cannot rename {} to {}: {}", from.string(), to.string(),
                                error.message());
        }
    }

    fs::path from_;
    fs::path to_;
    std::vector<std::string> placed_;
    std::vector<std::string> set_aside_;
};

}  // namespace

std::vector<ExportFile> csv_export(const StoreContents& contents) {
    Json dictionary;
    describe(dictionary, participants_export());
    describe(dictionary, sessions_export());
    describe(dictionary, trials_export());
    describe(dictionary, conditions_export());
    return {csv_file(participants_export(), contents.participants),
            csv_file(sessions_export(), contents.sessions),
            csv_file(trials_export(), trial_rows(contents)),
            csv_file(conditions_export(), condition_rows(contents)),
            {"data_dictionary.json", dictionary.dump(2) + '\n'}};
}

void write_export(const std::vector<ExportFile>& files, const fs::path& folder, bool overwrite) {
    base::require_writable_folder(folder, "--out");
    std::vector<std::string> there;
    for (const ExportFile& file : files) {
        std::error_code ignored;
        const fs::file_status status = fs::symlink_status(folder / file.name, ignored);
        if (fs::is_directory(status)) {
            throw base::bad_input("--out {}: {} is a folder there", folder.string(), file.name);
        }
        if (fs::exists(status)) there.push_back(file.name);
    }
    if (!overwrite && !there.empty()) {
        throw base::bad_input(
            "--out {}: {} {} there already; --force overwrites, or choose another folder",
            folder.string(), fmt::join(there, ", "), there.size() == 1 ? "is" : "are");
    }
    const PassingFolder partial(folder / fmt::format(".export-{}", ::getpid()));
    for (const ExportFile& file : files) {
        base::write_file_atomically(partial.path() / file.name, file.bytes);
    }
    Placement placement(partial.path(), folder);
    for (const ExportFile& file : files) placement.place(file.name);
    placement.keep();
}

}  // namespace obscura::analysis
