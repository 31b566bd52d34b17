// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/list.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string_view>

#include "app/kiosk/kiosk.h"
#include "app/kiosk/text_check.h"
#include "stimuli/manifest.h"
#include "stimuli/study.h"

namespace obscura::app {
namespace {

struct RunOptions {
    std::string study = "jakobsen2010";
    std::string store_url;
    int monitor = 0;
    bool windowed = false;
};

/// A store in a folder that is not there is most often a mistyped path: answers must not go astray.
void refuse_missing_folder(const std::string& url) {
    constexpr std::string_view kSqlite = "sqlite3://";
    if (!url.starts_with(kSqlite)) return;
    const std::filesystem::path folder =
        std::filesystem::path(url.substr(kSqlite.size())).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder)) {
        throw base::bad_input("--db: {}: there is no folder {}", url, folder.string());
    }
}

base::ExitCode run(const RunOptions& options, const Globals& globals) {
    refuse_missing_folder(options.store_url);
    const stimuli::Study study = stimuli::load_study(options.study, stimuli::SceneFiles::kTrusted);
    if (const auto problems = kiosk::problems_of_texts(study); !problems.empty()) {
        throw base::bad_input(
            "{}", stimuli::to_lines(problems, stimuli::study_source(options.study).name));
    }
    kiosk::KioskOptions kiosk_options;
    kiosk_options.folder = stimuli::stimuli_folder(globals.data, study);
    kiosk_options.store_url = options.store_url.empty() ? globals.store_url() : options.store_url;
    kiosk_options.remedy =
        fmt::format("obscura render {} --data {}", options.study, globals.data.string());
    kiosk_options.backups = globals.data / "backups";
    kiosk_options.monitor = options.monitor;
    kiosk_options.windowed = options.windowed;
    kiosk::run_kiosk(study, kiosk_options);
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_run(const Options& command, const Globals& globals) {
    auto options = std::make_shared<RunOptions>();
    command.add("study", options->study, "Study file, or name of a built-in study")
        .type("STUDY")
        .shows_default();
    command
        .add("--db", options->store_url,
             "Response store: sqlite3://FILE or postgresql://... (default: "
             "responses.sqlite in the data folder)")
        .type("URL");
    command.add("--monitor", options->monitor, "Monitor to fill, from 0")
        .type("N")
        .between(0, 99)
        .shows_default();
    command.add_flag("--windowed", options->windowed, "A plain window instead of a whole monitor");
    command.footer(
        "The operator begins with the next participant by Ctrl+Shift+N and leaves with "
        "Ctrl+Shift+Q.");
    return [options, &globals] { return run(*options, globals); };
}

}  // namespace

Command run_command() {
    return {"run", "The kiosk: runs participants through a study", &attach_run};
}

}  // namespace obscura::app
