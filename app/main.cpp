// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/list.h"
#include "app/commands/manual.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "stimuli/scenes/open_scene.h"

namespace {

using obscura::base::ExitCode;

/// An empty value is most often a script's unset variable: it must not mean "the default".
void refuse_empty_values(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word.empty()) {
            throw obscura::base::bad_input("the value after \"{}\" is empty", argv[i - 1]);
        }
        if (word.starts_with("--") && word.ends_with("=")) {
            throw obscura::base::bad_input("{}: its value is empty", word);
        }
    }
}

/// The first word that is neither an option nor a command is most often a command misspelt.
void name_unknown_command(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--data" || words[i] == "--allow") {
            ++i;
        } else if (!words[i].starts_with("-")) {
            std::string known;
            for (const obscura::app::Command& command : obscura::app::commands()) {
                if (command.name == words[i]) return;
                known += (known.empty() ? "" : ", ") + command.name;
            }
            throw obscura::base::bad_input("there is no command \"{}\"; there are {}", words[i],
                                           known);
        }
    }
}

/// `help` and `help COMMAND` as `--help` and `COMMAND --help`.
std::vector<std::string> words_of(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    return words;
}

int run(int argc, char** argv) {
    refuse_empty_values(argc, argv);
    obscura::app::CommandLine line(
        "Obscura: can people see the difference between ways of approximating ambient occlusion?",
        "obscura", OBSCURA_VERSION);
    const obscura::app::Options program = line.options();
    program.require_command();
    obscura::app::Globals globals;
    program.add("--data", globals.data, "Folder that holds a study's life").shows_default();
    program
        .add("--allow", globals.allowed,
             "A folder from which files that a scene names may be read, beside the scene's own; "
             "repeatable")
        .existing_folder()
        .repeatable();
    program.add_flag("--quiet", globals.quiet, "Say only warnings and errors");

    bool wants_manual = false;
    std::string shell;
    program.add("--completion", shell, "Print what a shell needs to complete words, and exit")
        .one_of(obscura::app::known_shells());
    program.add_flag("--manual", wants_manual, "Print the manual page (troff), and exit");

    std::function<ExitCode()> chosen;
    for (const obscura::app::Command& command : obscura::app::commands()) {
        const obscura::app::Options options = program.add_command(command.name, command.summary);
        options.when_given([&chosen, act = command.attach(options, globals)] { chosen = act; });
    }
    // These two need no command, which all else does.
    const std::vector<std::string> words = words_of(argc, argv);
    if (const std::string text = obscura::app::manual_or_completion(words, line.described());
        !text.empty()) {
        std::fputs(text.c_str(), stdout);
        return static_cast<int>(ExitCode::kDone);
    }
    name_unknown_command(words);
    if (!line.parse(words)) return static_cast<int>(ExitCode::kDone);
    obscura::base::log::set_up(globals.quiet);
    obscura::stimuli::allow_folders(globals.allowed);
    const ExitCode code = chosen();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw obscura::base::failure("cannot write to standard output: {}", std::strerror(errno));
    }
    return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const obscura::base::Error& error) {
        fmt::print(stderr, "obscura: {}\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        fmt::print(stderr, "obscura: {}\n", error.what());
        return static_cast<int>(ExitCode::kFailed);
    }
}
