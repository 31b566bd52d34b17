// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace obscura::analysis {

/// What a program left behind.
struct ProcessResult {
    std::string out;      ///< its standard output
    std::string problem;  ///< why it did not do its work; empty when it ended with 0
};

/// Runs a program of the PATH, without a shell, in the folder, with nothing to read, and waits for
/// it until `limit`, after which it is killed. `words` are its name and arguments. The problem
/// says whether it is absent, ran too long or failed, then with the end of its standard error.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& words,
                                        const std::filesystem::path& folder,
                                        std::chrono::milliseconds limit);

}  // namespace obscura::analysis
