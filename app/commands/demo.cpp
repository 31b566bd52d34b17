// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <memory>

#include "analysis/conclusions/exported_conclusions.h"
#include "analysis/export/contents.h"
#include "analysis/presentation/report.h"
#include "analysis/presentation/summary.h"
#include "analysis/presentation/text_report.h"
#include "analysis/published_votes.h"
#include "analysis/store/store.h"
#include "app/commands/exported_study.h"
#include "app/commands/list.h"
#include "app/commands/report_input.h"
#include "app/commands/simulated_store.h"
#include "app/commands/study_argument.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "renderer/base/own_folder.h"
#include "renderer/base/version.h"
#include "stimuli/generate.h"
#include "stimuli/view_names.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;
using analysis::Kind;
using analysis::Store;

struct DemoOptions {
    std::string study = "jakobsen2010";
    fs::path out;  ///< empty: DATA/demo
    int participants = 36;
    bool full = false;
};

/// Observers who choose as often as was published.
void simulate_published(const stimuli::Study& study, const fs::path& images,
                        const Simulation& simulation) {
    const kiosk::ChoiceModel choices = kiosk::choices_from(study, analysis::published_votes());
    if (!choices.unpublished.empty()) {
        base::log::warn(
            "no published votes for {}: observers choose either image with probability "
            "1/2 there",
            fmt::join(choices.unpublished, ", "));
    }
    simulate_into_store(study, stimuli::load_manifest(images / "manifest.json"), choices,
                        simulation);
}

/// Writes tables and the report, and gives the analysis as text, in one screen or in full.
[[nodiscard]] std::string analyse(const stimuli::Study& study,
                                  const analysis::ExportedStudy& exported, const fs::path& out,
                                  const fs::path& file, bool full) {
    const fs::path reports = out / "reports";
    Store store(store_url_of(file), Store::Access::kReadOnly);
    const analysis::StoreContents contents = analysis::read_contents(store);
    analysis::ExportOptions export_options;
    export_options.folder = reports / "export";
    export_options.overwrite = true;
    export_options.studies = {exported};
    export_options.software = base::program_version();
    (void)analysis::add_conclusions(export_options, store, store_url_of(file));
    (void)analysis::export_store(store, export_options);
    analysis::ReportInput input;
    analysis::Tally tally = analysis::tally_trials(store_url_of(file), contents.sessions,
                                                   contents.trials, study.name, Kind::kSimulated);
    analysis::name_views(tally, stimuli::view_names(study));
    input.analysis = analysis::analyse(std::move(tally));
    input.attendance = analysis::attendance_of(store, study.name, Kind::kSimulated);
    const auto asked = analysis::read_question_data(store, study.name, Kind::kSimulated);
    if (asked.has_value()) input.questions = analysis::analyse_questions(*asked);
    add_sources(input, {out, study, {}});
    analysis::write_report(analysis::report_files(input), reports);
    if (!full) return analysis::summary_text(input.analysis);
    return analysis::text_report(
        input.analysis, analysis::caveats_of(input.analysis, input.images, input.attendance));
}

base::ExitCode demo(const DemoOptions& options, const Globals& globals) {
    const fs::path out = options.out.empty() ? globals.data / "demo" : options.out;
    const std::string named = study_named(options.study, globals);
    const stimuli::Study study = stimuli::load_study(named);
    base::require_own_folder(
        out, "--out", [](const std::string& name) { return name.starts_with("responses.sqlite"); });
    base::require_writable_folder(out, "--out");
    const fs::path file = out / "responses.sqlite";
    refuse_real_answers(file, "--out");
    const fs::path images = stimuli::stimuli_folder(out, study);
    const stimuli::Generated generated = stimuli::generate(
        study, {.known = stimuli::stimuli_folder(globals.data, study)}, images, globals.quiet);
    base::log::info("{} images made, {} were there already", generated.made, generated.kept);
    simulate_published(study, images,
                       {file, "--out", options.participants, study.seed, globals.quiet,
                        stimuli::load_questions(named)});
    const std::string report =
        analyse(study, exported_study(stimuli::study_source(named), study, images), out, file,
                options.full);
    fmt::print("{}", report);
    fmt::print(
        "\n{} simulated; nobody has looked at these images.\n"
        "images    {}\nanswers   {}\ntables    {}\nreport    {}\n"
        "Next: open the report. obscura run {} shows the study to people; obscura check FILE reads "
        "one of your own.\n",
        options.participants == 1 ? "The observer is"
                                  : fmt::format("The {} observers are", options.participants),
        images.string(), file.string(), (out / "reports" / "export").string(),
        (out / "reports" / "report.html").string(), options.study);
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_demo(const Options& app, const Globals& globals) {
    auto options = std::make_shared<DemoOptions>();
    add_study(app, options->study);
    app.add("--out", options->out,
            "Folder of the demo, apart from that of real participants (default: DATA/demo)")
        .type("FOLDER");
    app.add("--participants", options->participants, "Simulated observers")
        .type("N")
        .between(1, 100000)
        .shows_default();
    app.add_flag("--full", options->full, "Print every test in words instead of one screen");
    app.footer(
        "Images that are there from the same inputs are kept; the store, tables and analysis of an "
        "earlier demo are replaced.");
    return [options, &globals] { return demo(*options, globals); };
}

}  // namespace

Command demo_command() {
    return {"demo",
            "Go through the whole study without a display: render, simulate, export, analyse",
            attach_demo};
}

}  // namespace obscura::app
