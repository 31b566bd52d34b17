// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>

#include "analysis/export/csv_export.h"
#include "analysis/store/store.h"
#include "app/commands/list.h"

namespace obscura::app {
namespace {

struct Options {
    std::string db;  ///< empty: the data folder's
    std::filesystem::path out;
    std::string format = "csv";
    bool force = false;
};

[[nodiscard]] std::string counted(std::size_t count, const char* thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

base::ExitCode export_answers(const Options& options, const Globals& globals) {
    const std::string url = options.db.empty() ? globals.store_url() : options.db;
    analysis::Store store(url, analysis::Store::Access::kReadOnly);
    const analysis::StoreContents contents = analysis::read_contents(store);
    analysis::write_export(analysis::csv_export(contents), options.out, options.force);

    const auto simulated = std::count_if(
        contents.sessions.begin(), contents.sessions.end(),
        [](const auto& session) { return session.kind == analysis::Kind::kSimulated; });
    spdlog::info("in {}: {}, {} ({} simulated), {}", options.out.string(),
                 counted(contents.participants.size(), "participant"),
                 counted(contents.sessions.size(), "session"), simulated,
                 counted(contents.trials.size(), "trial"));
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach(CLI::App& app, const Globals& globals) {
    auto options = std::make_shared<Options>();
    app.add_option("--db", options->db,
                   "Response store, sqlite3://FILE or postgresql://... "
                   "[sqlite3://DATA/responses.sqlite]");
    app.add_option("--out", options->out, "Folder for the files")->required();
    app.add_option("--format", options->format, "Kind of files: csv")
        ->check(CLI::IsMember({"csv"}))
        ->capture_default_str();
    app.add_flag("--force", options->force, "Overwrite files that are there");
    return [options, &globals] { return export_answers(*options, globals); };
}

}  // namespace

Command export_command() {
    return {"export", "Write the answers as tables with a data dictionary", attach};
}

}  // namespace obscura::app
