// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>

#include "app/commands/program.h"
#include "app/commit.h"
#include "renderer/base/colour.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "renderer/base/version.h"
#include "renderer/gl/context.h"
#include "stimuli/scenes/open_scene.h"

namespace {

using obscura::base::ExitCode;

/// Version, commit and driver, a line each.
std::string version_text() {
    std::string text = obscura::base::program_version() + '\n';
    if (!std::string_view(OBSCURA_COMMIT).empty()) text += "commit    " OBSCURA_COMMIT "\n";
    try {
        const obscura::renderer::HeadlessContext context;
        return text + "driver    " + obscura::renderer::gpu_description();
    } catch (const std::exception& error) {
        return text + "driver    none: " + error.what();
    }
}

void say_error(const char* what) {
    const bool colour = obscura::base::shows_colour();
    fmt::print(stderr, "{}obscura:{} {}\n", colour ? "\x1b[1;31m" : "", colour ? "\x1b[0m" : "",
               what);
}

int run(int argc, char** argv) {
    obscura::base::log::set_up(false);
    obscura::app::Program program(version_text);
    const auto chosen = program.parse({argv + 1, argv + argc});
    if (!chosen) return static_cast<int>(ExitCode::kDone);
    obscura::base::log::set_up(program.globals().quiet);
    obscura::stimuli::allow_folders(program.globals().allowed);
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
        say_error(error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        say_error(error.what());
        return static_cast<int>(ExitCode::kFailed);
    }
}
