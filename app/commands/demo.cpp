// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "analysis/export/contents.h"
#include "analysis/presentation/report.h"
#include "analysis/presentation/text_report.h"
#include "analysis/published_votes.h"
#include "analysis/store/store.h"
#include "app/commands/exported_study.h"
#include "app/commands/list.h"
#include "app/commands/report_input.h"
#include "app/kiosk/machine.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "app/kiosk/store_lock.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "renderer/base/progress.h"
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
};

[[nodiscard]] std::string url_of(const fs::path& file) { return "sqlite3://" + file.string(); }

/// A demo is made anew each time; a store that holds anybody's real answers is not replaced.
void refuse_real_answers(const fs::path& file) {
    // An empty file, of a program that ended before it made its tables, holds nobody's answers.
    if (!fs::exists(file) || fs::file_size(file) == 0) return;
    Store store(url_of(file), Store::Access::kReadOnly);
    const auto sessions = store.sessions();
    const bool simulated = std::all_of(sessions.begin(), sessions.end(), [](const auto& session) {
        return session.kind == Kind::kSimulated;
    });
    if (!simulated) {
        throw base::bad_input(
            "--out: {} holds answers of participants; the demo replaces its store, give it another "
            "folder",
            file.string());
    }
}

/// What SQLite keeps beside a store while it is open; it must not outlive its store.
void remove_log(const fs::path& file) {
    for (const char* ending : {"-wal", "-shm", "-journal"}) fs::remove(file.string() + ending);
}

[[nodiscard]] kiosk::SessionPlan plan_of(const stimuli::Study& study,
                                         const stimuli::Manifest& manifest,
                                         const std::vector<std::uint64_t>& taken, int number) {
    kiosk::SessionPlan plan;
    plan.participant_id = fmt::format("simulated-p{:04}", number);
    plan.session_id = fmt::format("simulated-s{:04}", number);
    plan.kind = Kind::kSimulated;
    plan.images = kiosk::images_of(study, manifest);
    plan.order = stimuli::session_order(study.order, static_cast<int>(plan.images.size()),
                                        study.seed, stimuli::next_slot(taken));
    plan.machine = kiosk::simulated_machine();
    return plan;
}

/// Every observer through the kiosk's procedure into a new store.
void simulate(const stimuli::Study& study, const fs::path& images, const fs::path& file,
              int participants, bool quiet) {
    const kiosk::ChoiceModel choices = kiosk::choices_from(study, analysis::published_votes());
    if (!choices.unpublished.empty()) {
        base::log::warn(
            "no published votes for {}: observers choose either image with probability "
            "1/2 there",
            fmt::join(choices.unpublished, ", "));
    }
    const stimuli::Manifest manifest = stimuli::load_manifest(images / "manifest.json");
    Store store(url_of(file), Store::Access::kThrowaway);
    kiosk::VirtualClock clock;
    base::Progress progress("simulate", static_cast<std::size_t>(participants), quiet);
    for (int number = 1; number <= participants; ++number) {
        kiosk::Procedure procedure(
            study, plan_of(study, manifest,
                           store.taken_slots(study.name, study.seed, Kind::kSimulated), number));
        kiosk::Journal journal = kiosk::journal_to(store);
        base::Random random(kiosk::observer_seed(study.seed, static_cast<std::uint64_t>(number)));
        kiosk::simulate_observer(procedure, choices, random, clock, journal);
        progress.step(fmt::format("observer {}", number));
    }
}

/// Beside and renamed: an interrupted demo leaves the store of the last one.
void make_store(const stimuli::Study& study, const fs::path& images, const fs::path& file,
                int participants, bool quiet) {
    // Nobody's answers may come in between the question and the replacement.
    const kiosk::StoreLock lock(url_of(file));
    refuse_real_answers(file);
    const fs::path beside = file.string() + ".new";
    fs::remove(beside);
    remove_log(beside);
    simulate(study, images, beside, participants, quiet);
    remove_log(file);
    fs::rename(beside, file);
}

/// Writes tables and the report, and gives the analysis as text.
[[nodiscard]] std::string analyse(const stimuli::Study& study,
                                  const analysis::ExportedStudy& exported, const fs::path& out,
                                  const fs::path& file) {
    const fs::path reports = out / "reports";
    Store store(url_of(file), Store::Access::kReadOnly);
    const analysis::StoreContents contents = analysis::read_contents(store);
    analysis::ExportOptions export_options;
    export_options.folder = reports / "export";
    export_options.overwrite = true;
    export_options.studies = {exported};
    export_options.software = kiosk::software_version();
    (void)analysis::export_store(store, export_options);
    analysis::ReportInput input;
    analysis::Tally tally = analysis::tally_trials(url_of(file), contents.sessions, contents.trials,
                                                   study.name, Kind::kSimulated);
    analysis::name_views(tally, stimuli::view_names(study));
    input.analysis = analysis::analyse(std::move(tally));
    input.attendance = analysis::attendance_of(store, study.name, Kind::kSimulated);
    add_sources(input, {out, study, {}});
    analysis::write_report(analysis::report_files(input), reports);
    return analysis::text_report(input.analysis);
}

base::ExitCode demo(const DemoOptions& options, const Globals& globals) {
    const fs::path out = options.out.empty() ? globals.data / "demo" : options.out;
    const stimuli::Study study = stimuli::load_study(options.study);
    base::require_writable_folder(out, "--out");
    const fs::path file = out / "responses.sqlite";
    refuse_real_answers(file);
    const fs::path images = stimuli::stimuli_folder(out, study);
    const stimuli::Generated generated = stimuli::generate(study, {}, images, globals.quiet);
    base::log::info("{} images made, {} were there already", generated.made, generated.kept);
    make_store(study, images, file, options.participants, globals.quiet);
    const std::string report = analyse(
        study, exported_study(stimuli::study_source(options.study), study, images), out, file);
    fmt::print("{}", report);
    fmt::print(
        "\n{} simulated; nobody has looked at these images.\n"
        "images    {}\nanswers   {}\ntables    {}\nreport    {}\n",
        options.participants == 1 ? "The observer is"
                                  : fmt::format("The {} observers are", options.participants),
        images.string(), file.string(), (out / "reports" / "export").string(),
        (out / "reports" / "report.html").string());
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_demo(const Options& app, const Globals& globals) {
    auto options = std::make_shared<DemoOptions>();
    app.add("study", options->study, "Study file, or name of a built-in study")
        .type("STUDY")
        .shows_default();
    app.add("--out", options->out,
            "Folder of the demo, apart from that of real participants [DATA/demo]")
        .type("DIR");
    app.add("--participants", options->participants, "Simulated observers")
        .type("N")
        .between(1, 100000)
        .shows_default();
    app.footer(
        "Images that are there from the same inputs are kept; the store, tables and analysis of an "
        "earlier demo are replaced.");
    return [options, &globals] { return demo(*options, globals); };
}

}  // namespace

Command demo_command() {
    return {"demo", "The whole study without a display: render, simulate, export, analyse",
            attach_demo};
}

}  // namespace obscura::app
