// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <string>

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

/// The error whose text is the formatted message; behind the three below, so that the formatting
/// itself is compiled once.
[[nodiscard]] Error formatted_error(ExitCode code, fmt::string_view format, fmt::format_args args);

/// The work failed: exit code 1. Arguments as fmt::format.
template <typename... Args>
[[nodiscard]] Error failure(fmt::format_string<Args...> format, Args&&... args) {
    return formatted_error(ExitCode::kFailed, format, fmt::make_format_args(args...));
}

/// The command line or an input file is wrong: exit code 2. Arguments as fmt::format.
template <typename... Args>
[[nodiscard]] Error bad_input(fmt::format_string<Args...> format, Args&&... args) {
    return formatted_error(ExitCode::kBadInput, format, fmt::make_format_args(args...));
}

/// A check ran and did not hold: exit code 3. Arguments as fmt::format.
template <typename... Args>
[[nodiscard]] Error check_failed(fmt::format_string<Args...> format, Args&&... args) {
    return formatted_error(ExitCode::kCheckFailed, format, fmt::make_format_args(args...));
}

}  // namespace obscura::base
