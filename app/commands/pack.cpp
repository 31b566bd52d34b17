// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <set>

#include "app/commands/list.h"
#include "app/commands/study_argument.h"
#include "renderer/base/log.h"
#include "stimuli/manifest.h"
#include "stimuli/package/package.h"

namespace obscura::app {
namespace {

struct PackOptions {
    std::string study;
    std::filesystem::path out;
};

base::ExitCode pack(const PackOptions& options, const Globals& globals) {
    if (stimuli::is_package(options.study)) {
        throw base::bad_input("STUDY: {} is a package already", options.study);
    }
    const stimuli::StudySource source = stimuli::study_source(options.study);
    const std::string name =
        stimuli::parse_study(source.text, source.name, source.folder, stimuli::SceneFiles::kTrusted)
            .name;
    const std::filesystem::path out =
        options.out.empty() ? std::filesystem::path(name + ".zip") : options.out;
    const stimuli::Package package = stimuli::pack(source, globals.data / "stimuli" / name, out);
    std::set<std::string> without;
    for (const stimuli::SceneLicence& one : package.licences) {
        if (one.licence.empty()) without.insert(one.source);
    }
    for (const std::string& file : without) {
        base::log::warn(
            "warning: nobody says under which licence {} may be passed on; say it in its "
            "[[scene]]: licence = \"...\"",
            file);
    }
    base::log::info("{}: study {}, {} files; next: obscura check {}", out.string(), package.study,
                    package.files, out.string());
    return base::ExitCode::kDone;
}

}  // namespace

Command pack_command() {
    return {"pack", "Put a study with its images and scenes into one file for another machine",
            [](const Options& app, const Globals& globals) -> std::function<base::ExitCode()> {
                const auto options = std::make_shared<PackOptions>();
                add_study(app, options->study);
                app.add("--out", options->out, "File to write, ends in .zip (default: STUDY.zip)");
                app.footer(
                    "The images are those of DATA/stimuli/STUDY. Every command that takes a STUDY "
                    "takes the file; it is unpacked into the data folder.");
                return [options, &globals] { return pack(*options, globals); };
            }};
}

}  // namespace obscura::app
