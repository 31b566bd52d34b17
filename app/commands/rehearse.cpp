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
    int participants = 0;
    ObserverOptions observers;
    std::optional<std::uint64_t> seed;  ///< nothing: the study's
    fs::path store;                     ///< empty: DATA/rehearsal/STUDY.sqlite
};

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
    const fs::path file = options.store.empty()
                              ? globals.data / "rehearsal" / (study.name + ".sqlite")
                              : options.store;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    base::require_writable_folder(folder, "--store");
    simulate_into_store(study, rendered_images(study, globals.data), choices,
                        {file, "--store", options.participants, options.seed.value_or(study.seed),
                         globals.quiet, stimuli::load_questions(named)});
    fmt::print(
        "{} through the study {}, simulated: nobody has looked at these images.\n"
        "answers   {}\n"
        "analyse   obscura analyze --db {} --kind simulated\n",
        options.participants == 1 ? "1 observer"
                                  : fmt::format("{} observers", options.participants),
        study.name, file.string(), store_url_of(file));
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_rehearse(const Options& app, const Globals& globals) {
    auto options = std::make_shared<RehearseOptions>();
    add_study(app, options->study);
    app.add("--participants", options->participants, "Simulated observers")
        .type("N")
        .required()
        .between(1, 100000);
    add_observer_options(app, options->observers);
    app.add("--seed", options->seed, "Of the observers' answers (default: the study's)");
    app.add("--store", options->store,
            "File for the answers, replaced unless it holds answers of participants "
            "(default: DATA/rehearsal/STUDY.sqlite)")
        .type("FILE");
    app.footer(
        "The observers go through the kiosk's procedure on a clock of their own; every row of the "
        "store says that they are simulated, and so does every report of it. Their answers stand "
        "on no image: the images need not be rendered.");
    return [options, &globals] { return rehearse(*options, globals); };
}

}  // namespace

Command rehearse_command() {
    return {"rehearse",
            "Simulated observers through a study, to try its analysis before anybody comes",
            attach_rehearse};
}

}  // namespace obscura::app
