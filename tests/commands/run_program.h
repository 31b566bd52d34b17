// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "renderer/base/files.h"

namespace obscura::app {

/// What a run of the program left: exit code, or -1 when a signal ended it, and its two streams.
struct ProgramRun {
    int exit_code = -1;
    std::string out;
    std::string err;
};

/// A folder of the running test, empty at its start and gone after it.
class TestFolder {
  public:
    TestFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::path(testing::TempDir()) /
                (std::string("obscura-") + test->test_suite_name() + "-" + test->name());
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Runs `obscura ARGUMENTS` in the folder; the arguments are words of the shell.
inline ProgramRun run_program(const TestFolder& folder, const std::string& arguments) {
    const std::string command = "cd '" + folder.path().string() + "' && '" OBSCURA_PROGRAM "' " +
                                arguments + " >stdout.txt 2>stderr.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            base::read_file(folder.path() / "stdout.txt"),
            base::read_file(folder.path() / "stderr.txt")};
}

}  // namespace obscura::app
