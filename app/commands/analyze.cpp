// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "analysis/counts_file.h"
#include "analysis/report/analysis.h"
#include "analysis/store/store.h"
#include "analysis/tally.h"
#include "analysis/trials_file.h"
#include "app/commands/list.h"
#include "renderer/base/files.h"

namespace obscura::app {
namespace {

struct Options {
    std::string db;  ///< empty: the data folder's
    std::string counts;
    std::string trials;
    std::string study;
    std::string kind = "participant";
    bool json = false;
    std::filesystem::path out;  ///< empty: nothing is written
};

analysis::Tally tally_of_store(const std::string& url, const Options& options) {
    analysis::Store store(url, analysis::Store::Access::kReadOnly);
    const auto kind = analysis::kind_from(options.kind);
    return analysis::tally_of(analysis::read_answers(store, url), options.study, *kind);
}

analysis::Tally tally_of(const Options& options, const Globals& globals) {
    if (!options.counts.empty()) return analysis::read_counts(options.counts);
    if (options.trials.empty()) {
        return tally_of_store(options.db.empty() ? globals.store_url() : options.db, options);
    }
    return analysis::tally_of(analysis::read_trials(options.trials), options.study,
                              *analysis::kind_from(options.kind));
}

base::ExitCode analyze(const Options& options, const Globals& globals) {
    if (!options.out.empty()) base::require_writable_folder(options.out, "--out");
    const analysis::Analysis result = analysis::analyse(tally_of(options, globals));
    const std::string text = analysis::text_report(result);
    const std::string json = analysis::json_report(result);
    if (!options.out.empty()) {
        base::write_file_atomically(options.out / "analysis.txt", text);
        base::write_file_atomically(options.out / "analysis.json", json);
    }
    fmt::print("{}", options.json ? json : text);
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach(CLI::App& app, const Globals& globals) {
    auto options = std::make_shared<Options>();
    auto* db = app.add_option("--db", options->db,
                              "Response store, sqlite3://FILE or postgresql://... "
                              "[sqlite3://DATA/responses.sqlite]");
    auto* counts = app.add_option(
        "--counts", options->counts,
        "Votes from a CSV file: condition,hypothesis,validity,variant_a,variant_b,count_a,count_b");
    auto* trials = app.add_option(
        "--trials", options->trials,
        "Answers from a CSV file, one row a trial: observer,condition_A,condition_B,is_A_selected "
        "and optional session_id,scene,order; or an exported trials.csv");
    auto* study =
        app.add_option("--study", options->study, "Study to analyse, where there are several");
    auto* kind = app.add_option("--kind", options->kind, "Whose answers: participant or simulated")
                     ->check(CLI::IsMember({"participant", "simulated"}))
                     ->capture_default_str();
    counts->excludes(db)->excludes(trials)->excludes(study)->excludes(kind);
    trials->excludes(db);
    app.add_flag("--json", options->json, "Print JSON instead of a table");
    app.add_option("--out", options->out, "Folder for analysis.txt and analysis.json");
    return [options, &globals] { return analyze(*options, globals); };
}

}  // namespace

Command analyze_command() {
    return {"analyze", "Test the answers: is one image preferred, and where?", attach};
}

}  // namespace obscura::app
