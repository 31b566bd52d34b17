// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>

#include "app/commands/list.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"

namespace {

using obscura::base::ExitCode;

int run(int argc, char** argv) {
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
    program.add_flag("--quiet", globals.quiet, "Say only warnings and errors");

    std::function<ExitCode()> chosen;
    for (const obscura::app::Command& command : obscura::app::commands()) {
        CLI::App* options = program.add_subcommand(command.name, command.summary);
        options->callback([&chosen, act = command.attach(*options, globals)] { chosen = act; });
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::kBadInput);
    }
    obscura::base::set_up_log(globals.quiet);
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
