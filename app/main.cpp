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

#include "app/commands/list.h"
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
void name_unknown_command(const CLI::App& program, int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--data" || word == "--allow") {
            ++i;
        } else if (!word.starts_with("-")) {
            std::string known;
            for (const CLI::App* command : program.get_subcommands({})) {
                if (command->get_name() == word) return;
                known += (known.empty() ? "" : ", ") + command->get_name();
            }
            throw obscura::base::bad_input("there is no command \"{}\"; there are {}", word, known);
        }
    }
}

int run(int argc, char** argv) {
    refuse_empty_values(argc, argv);
    CLI::App program{
        "Obscura: can people see the difference between ways of approximating ambient "
        "occlusion?",
        "obscura"};
    program.set_version_flag("--version", std::string(OBSCURA_VERSION));
    program.require_subcommand(1);
    program.fallthrough();
    obscura::app::Globals globals;
    program.add_option("--data", globals.data, "Folder that holds a study's life")
        ->capture_default_str();
    program
        .add_option("--allow", globals.allowed,
                    "A folder from which files that a scene names may be read, beside the scene's "
                    "own; repeatable")
        ->check(CLI::ExistingDirectory)
        ->allow_extra_args(false);
    program.add_flag("--quiet", globals.quiet, "Say only warnings and errors");

    std::function<ExitCode()> chosen;
    for (const obscura::app::Command& command : obscura::app::commands()) {
        CLI::App* options = program.add_subcommand(command.name, command.summary);
        options->callback([&chosen, act = command.attach(*options, globals)] { chosen = act; });
    }
    name_unknown_command(program, argc, argv);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::kBadInput);
    }
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
