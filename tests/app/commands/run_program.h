// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "renderer/base/files.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app {

/// What a run of the program left: exit code, or -1 when a signal ended it, and its two streams.
struct ProgramRun {
    int exit_code = -1;
    std::string out;
    std::string err;
};

/// Runs `obscura ARGUMENTS` in the folder; the arguments are words of the shell.
inline ProgramRun run_program(const tests::TemporaryFolder& folder, const std::string& arguments) {
    const std::string command = "cd '" + folder.path().string() + "' && '" OBSCURA_PROGRAM "' " +
                                arguments + " >stdout.txt 2>stderr.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            base::read_file(folder.path() / "stdout.txt"),
            base::read_file(folder.path() / "stderr.txt")};
}

}  // namespace obscura::app
