// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "app/commands/list.h"
#include "app/commands/observer_options.h"
#include "app/commands/simulated_store.h"
#include "app/commands/study_argument.h"
#include "renderer/base/files.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;

struct RehearseOptions {
    std::string study;
    std::optional<int> participants;  ///< nothing: as many as the study plans, else 36
    ObserverOptions observers;
    std::optional<std::uint64_t> seed;  ///< nothing: the study's
    std::string store;                  ///< empty: DATA/rehearsal/STUDY.sqlite
};

constexpr int kUsualParticipants = 36;

int participants_of(const RehearseOptions& options, const stimuli::Study& study) {
    const std::vector<int>& looks = study.stopping.looks;
    return options.participants.value_or(looks.empty() ? kUsualParticipants : looks.back());
}

/// The file that the answers go into.
fs::path file_of(const RehearseOptions& options, const stimuli::Study& study,
                 const Globals& globals) {
    if (options.store.empty()) return globals.data / "rehearsal" / (study.name + ".sqlite");
    constexpr std::string_view kScheme = "sqlite3://";
    if (options.store.starts_with(kScheme)) return options.store.substr(kScheme.size());
    if (options.store.find("://") == std::string::npos) return options.store;
    throw base::bad_input("--db {}: simulated answers go into an SQLite file", options.store);
}

/// The images that were rendered, else none: an analysis needs no pixel of them, and a hash that is
/// not there says so.
stimuli::Manifest rendered_images(const stimuli::Study& study, const fs::path& data) {
    const fs::path made = stimuli::stimuli_folder(data, study) / "manifest.json";
    if (fs::exists(made)) return stimuli::load_manifest(made);
    stimuli::Manifest manifest;
    manifest.study = study.name;
    for (const stimuli::Condition& condition : study.conditions) {
        for (const char* side : {"a", "b"}) {
            stimuli::ManifestImage& image = manifest.images.emplace_back();
            image.condition = condition.id;
            image.side = side;
        }
    }
    return manifest;
}

base::ExitCode rehearse(const RehearseOptions& options, const Globals& globals) {
    const std::string named = study_named(options.study, globals);
    const stimuli::Study study = stimuli::load_study(named, stimuli::SceneFiles::kTrusted);
    const kiosk::ChoiceModel choices = choices_from(options.observers, study);
    const fs::path file = file_of(options, study, globals);
    const int participants = participants_of(options, study);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    base::require_writable_folder(folder, "--db");
    simulate_into_store(study, rendered_images(study, globals.data), choices,
                        {file, "--db", participants, options.seed.value_or(study.seed),
                         globals.quiet, stimuli::load_questions(named)});
    fmt::print(
        "{} through the study {}, simulated: nobody has looked at these images.\n"
        "answers   {}\n"
        "analyse   obscura analyze {} --kind simulated --db {}\n",
        participants == 1 ? "1 observer" : fmt::format("{} observers", participants), study.name,
        file.string(), options.study.empty() ? study.name : options.study, file.string());
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_rehearse(const Options& app, const Globals& globals) {
    auto options = std::make_shared<RehearseOptions>();
    add_study(app, options->study);
    app.add("--participants", options->participants,
            fmt::format("Simulated observers (default: as many as the study's last "
                        "look, else {})",
                        kUsualParticipants))
        .between(1, 100000);
    add_observer_options(app, options->observers);
    app.add("--seed", options->seed, "Seed of the observers' answers (default: the study's)");
    app.add("--db", options->store,
            "Store of the answers: an SQLite file, replaced unless it holds answers of "
            "participants (default: DATA/rehearsal/STUDY.sqlite)")
        .type("FILE|URL");
    app.footer(
        "The observers go through the kiosk's procedure on a clock of their own; every row of the "
        "store says that they are simulated, and so does every report of it. Their answers stand "
        "on no image: the images need not be rendered.");
    return [options, &globals] { return rehearse(*options, globals); };
}

}  // namespace

Command rehearse_command() {
    return {"rehearse",
            "Send simulated observers through a study, to try its analysis before anybody comes",
            attach_rehearse};
}

}  // namespace obscura::app
