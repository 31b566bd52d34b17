// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/list.h"
#include "app/commands/store_argument.h"
#include "app/commands/study_argument.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string_view>

#include "analysis/plot/gnuplot.h"
#include "app/kiosk/kiosk.h"
#include "app/kiosk/pin.h"
#include "app/kiosk/self_test.h"
#include "app/kiosk/text_check.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "stimuli/manifest.h"
#include "stimuli/study.h"

namespace obscura::app {
namespace {

constexpr const char* kNotAsked = "not asked";

struct RunOptions {
    std::string study = "jakobsen2010";
    std::string store_url;
    std::string monitor;  ///< its name or number; empty: the last one
    std::optional<double> viewing_distance_cm;
    std::string screen_size;
    std::optional<double> luminance_cd_m2;
    std::optional<double> gamma;
    std::string response_box;
    int box_rate = 9600;
    std::vector<std::string> box_keys;
    bool photodiode = false;
    bool windowed = false;
    std::string override_reason;
    bool set_pin = false;
    std::string self_test = kNotAsked;  ///< alternations; empty: the usual number
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

constexpr int kUsualAlternations = 200;
constexpr int kMostAlternations = 100'000;

int alternations_in(const std::string& text) {
    if (text.empty()) return kUsualAlternations;
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 1 ||
        count > kMostAlternations) {
        throw base::bad_input("--selftest {}: allowed is a number of alternations, 1 to {}", text,
                              kMostAlternations);
    }
    return count;
}

analysis::Plot plot_of(const kiosk::SelfTestRun& run) {
    analysis::Plot plot;
    plot.name = "selftest";
    plot.title = "Error of an interval between two images, and key to swap";
    plot.script =
        "set xlabel 'repetition'\nset ylabel 'ms'\nset key top right\n"
        "plot 'error_ms.tsv' using 1:2 with points lt 1 title 'interval: measured - asked', "
        "'key_to_swap_ms.tsv' using 1:2 with points lt 2 title 'key to swap'\n";
    const auto table = [](const std::vector<double>& values) {
        std::string text;
        for (std::size_t i = 0; i < values.size(); ++i) {
            text += fmt::format("{}\t{}\n", i + 1, values[i]);
        }
        return text;
    };
    plot.data = {{"error_ms.tsv", table(run.error_ms)},
                 {"key_to_swap_ms.tsv", table(run.key_to_swap_ms)}};
    return plot;
}

/// Says what was measured and keeps it for the sessions to come.
base::ExitCode self_test(const stimuli::Study& study, const kiosk::KioskOptions& options,
                         int alternations, bool quiet) {
    if (!quiet) {
        fmt::print(stderr, "{} alternations, about {} s: leave the machine alone\n", alternations,
                   alternations * 3 / 10 + 5);
    }
    const kiosk::SelfTestRun run = kiosk::run_self_test(study, options, alternations);
    const std::filesystem::path file = kiosk::self_test_file(options.data);
    std::filesystem::create_directories(file.parent_path());
    const analysis::DrawnPlot drawn = analysis::draw(plot_of(run), file.parent_path());
    if (!drawn.note.empty()) base::log::warn("{}", drawn.note);
    base::write_file_atomically(file, kiosk::to_json(run.test));
    fmt::print("{}", kiosk::to_text(run.test));
    fmt::print(stderr, "kept in {}, with each repetition and a plot beside it\n", file.string());
    return run.test.holds() ? base::ExitCode::kDone : base::ExitCode::kCheckFailed;
}

/// From the terminal or a pipe; it stands in no command line.
base::ExitCode set_pin(const std::filesystem::path& data) {
    fmt::print(stderr, "PIN for the operator's page, {} to {} digits; nothing takes it away: ",
               kiosk::kShortestPin, kiosk::kLongestPin);
    std::string pin;
    std::getline(std::cin, pin);
    std::filesystem::create_directories(data);
    kiosk::set_pin(kiosk::pin_file(data), pin);
    fmt::print(stderr, "{}\n", pin.empty() ? "the operator's page needs no PIN" : "kept, hashed");
    return base::ExitCode::kDone;
}

kiosk::DisplayFacts facts_of(const RunOptions& options) {
    kiosk::DisplayFacts facts;
    facts.viewing_distance_cm = options.viewing_distance_cm;
    facts.luminance_cd_m2 = options.luminance_cd_m2;
    facts.gamma = options.gamma;
    if (!options.screen_size.empty()) kiosk::set_screen_size(facts, options.screen_size);
    kiosk::check(facts);
    return facts;
}

kiosk::ResponseBoxOptions box_of(const RunOptions& options) {
    if (options.response_box.empty() && !options.box_keys.empty()) {
        throw base::bad_input("--box-key {}: it needs --response-box", options.box_keys.front());
    }
    kiosk::ResponseBoxOptions box{options.response_box, options.box_rate};
    for (const std::string& key : options.box_keys) kiosk::add_box_key(box, key);
    return box;
}

base::ExitCode run(const RunOptions& options, const Globals& globals) {
    refuse_missing_folder(options.store_url.empty() ? ""
                                                    : store_url_from(options.store_url, globals));
    const std::string named = study_named(options.study, globals);
    const stimuli::Study study = stimuli::load_study(named, stimuli::SceneFiles::kTrusted);
    if (const auto problems = kiosk::problems_of_texts(study); !problems.empty()) {
        throw base::bad_input("{}", stimuli::to_lines(problems, stimuli::study_source(named).name));
    }
    kiosk::KioskOptions kiosk_options;
    kiosk_options.folder = stimuli::stimuli_folder(globals.data, study);
    kiosk_options.store_url = store_url_from(options.store_url, globals);
    kiosk_options.remedy = fmt::format("obscura render {} --data {}", named, globals.data.string());
    kiosk_options.backups = globals.data / "backups";
    kiosk_options.monitor = options.monitor;
    kiosk_options.windowed = options.windowed;
    kiosk_options.override_reason = options.override_reason;
    kiosk_options.data = globals.data;
    kiosk_options.facts = facts_of(options);
    kiosk_options.response_box = box_of(options);
    kiosk_options.photodiode = options.photodiode;
    kiosk_options.questions = stimuli::load_questions(named);
    if (options.set_pin) return set_pin(globals.data);
    if (options.self_test != kNotAsked) {
        return self_test(study, kiosk_options, alternations_in(options.self_test), globals.quiet);
    }
    kiosk::run_kiosk(study, kiosk_options);
    return base::ExitCode::kDone;
}

void add_display_facts(const Options& command, RunOptions& options) {
    command
        .add(
            "--viewing-distance", options.viewing_distance_cm,
            "Eye to screen, in cm. This and what follows is said once for a monitor: it is kept in "
            "DATA/display.json and goes into every session, with the degrees of visual angle")
        .type("NUMBER");
    command.add("--screen-size", options.screen_size, "Width and height of what is lit, in cm")
        .type("WxH");
    command.add("--luminance", options.luminance_cd_m2, "Of white, as measured, in cd/m2")
        .type("NUMBER");
    command.add("--gamma", options.gamma, "Of the monitor, as measured").type("NUMBER");
}

void add_response_box(const Options& command, RunOptions& options) {
    command
        .add("--response-box", options.response_box,
             "Serial line of a response box, /dev/ttyUSB0, that sends a line of text for each "
             "press: a key's name as in a study file, or what --box-key makes one")
        .type("FILE");
    command.add("--box-rate", options.box_rate, "Of that line, in bits a second")
        .type("N")
        .shows_default();
    command
        .add("--box-key", options.box_keys,
             "The key that a line of the box stands for, as in B1=left")
        .type("LINE=KEY")
        .repeatable();
    command.add_flag("--photodiode", options.photodiode,
                     "A square in the lower left corner, white while an image is shown and black "
                     "else, for an instrument that checks the times");
}

std::function<base::ExitCode()> attach_run(const Options& command, const Globals& globals) {
    auto options = std::make_shared<RunOptions>();
    add_study(command, options->study);
    add_store(command, options->store_url);
    command
        .add("--monitor", options->monitor,
             "Monitor to fill: its number from 0 or its name (default: the last one, at first 0)")
        .type("N|NAME");
    add_display_facts(command, *options);
    add_response_box(command, *options);
    command.add_flag("--windowed", options->windowed, "A plain window instead of a whole monitor");
    command.add_flag("--set-pin", options->set_pin,
                     "No session: ask for the PIN of the operator's page and keep it");
    command
        .add("--override", options->override_reason,
             "Go on where the start refuses for little disk, a clock that ran backwards or a "
             "failed refresh test; the reason goes into every row")
        .type("REASON");
    command
        .add("--selftest", options->self_test,
             fmt::format("No session: measure how well intervals are kept and how soon a key "
                         "changes the screen, over N alternations of an image and grey (default "
                         "{}); exit code 3 where they cannot be relied on. Each later session "
                         "carries it",
                         kUsualAlternations))
        .type("[N]")
        .value_optional();
    command.footer(
        "The operator begins with the next participant by Ctrl+Shift+N. Ctrl+Shift+Q opens the "
        "operator's page: how the study and the machine stand, backing up, withdrawing a "
        "participant, leaving.");
    return [options, &globals] { return run(*options, globals); };
}

}  // namespace

Command run_command() {
    return {"run", "Run participants through a study: the kiosk", &attach_run};
}

}  // namespace obscura::app
