// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/commands/command.h"

namespace obscura::app {

/// Every command with its options behind one command line.
class Program {
  public:
    /// `version` is asked for by --version only.
    explicit Program(std::function<std::string()> version);

    /// What the words after the program's name ask for; nothing where that was help, the version,
    /// the manual or a shell's completion, which are printed. Throws bad input for what is not
    /// allowed.
    [[nodiscard]] std::function<base::ExitCode()> parse(std::vector<std::string> words);

    [[nodiscard]] const Globals& globals() const { return globals_; }
    /// Every command and option, for manuals.
    [[nodiscard]] DescribedCommand described() const { return line_.described(); }

  private:
    CommandLine line_;
    Globals globals_;
    bool wants_manual_ = false;
    std::string shell_;
    std::function<base::ExitCode()> chosen_;
};

}  // namespace obscura::app
