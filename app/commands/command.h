// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "renderer/base/error.h"

namespace obscura::app {

/// What every command understands.
struct Globals {
    std::filesystem::path data = "obscura-data";  ///< --data: where a study's files lie
    std::vector<std::filesystem::path> allowed;   ///< --allow: where scenes' files may lie, too
    bool quiet = false;                           ///< --quiet: warnings and errors only

    /// The response store's default URL.
    [[nodiscard]] std::string store_url() const {
        return "sqlite3://" + (data / "responses.sqlite").string();
    }
};

/// One word of the command line. `attach` adds its options and gives back what runs it; the
/// globals are filled in by the time that is called.
struct Command {
    std::string name;
    std::string summary;
    std::function<base::ExitCode()> (*attach)(const Options& options,
                                              const Globals& globals) = nullptr;
};

}  // namespace obscura::app
