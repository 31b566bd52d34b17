// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace obscura::base {

/// What the process returns to the shell.
enum class ExitCode : int {
    kDone = 0,         ///< all that was asked is done
    kFailed = 1,       ///< the work failed (disk, driver, database)
    kBadInput = 2,     ///< the command line or an input file is wrong
    kCheckFailed = 3,  ///< a check ran and did not hold
};

/// The one error type of the house. Its text is written for the person at the terminal: what was
/// wrong, where (file and line, or option), the value met and what is allowed.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const noexcept { return code_; }

  private:
    ExitCode code_;
};

/// The work failed: exit code 1. Arguments as fmt::format.
template <typename... Args>
[[nodiscard]] Error failure(fmt::format_string<Args...> format, Args&&... args) {
    return {ExitCode::kFailed, fmt::format(format, std::forward<Args>(args)...)};
}

/// The command line or an input file is wrong: exit code 2. Arguments as fmt::format.
template <typename... Args>
[[nodiscard]] Error bad_input(fmt::format_string<Args...> format, Args&&... args) {
    return {ExitCode::kBadInput, fmt::format(format, std::forward<Args>(args)...)};
}

/// A check ran and did not hold: exit code 3. Arguments as fmt::format.
template <typename... Args>
[[nodiscard]] Error check_failed(fmt::format_string<Args...> format, Args&&... args) {
    return {ExitCode::kCheckFailed, fmt::format(format, std::forward<Args>(args)...)};
}

}  // namespace obscura::base
