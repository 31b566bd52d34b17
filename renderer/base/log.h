// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <string>
#include <utility>

/// What is said to the person at the terminal, on stderr. The log's own header is so heavy that it
/// stands in log.cpp alone.
namespace obscura::base::log {

enum class Level { kInfo, kWarning, kError };

/// Without time stamps; `quiet` leaves warnings and errors only.
void set_up(bool quiet);

/// A line, as it is.
void say(Level level, const std::string& line);

/// A line, with arguments as of fmt::format.
template <typename... Args>
void info(fmt::format_string<Args...> format, Args&&... args) {
    say(Level::kInfo, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void warn(fmt::format_string<Args...> format, Args&&... args) {
    say(Level::kWarning, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void error(fmt::format_string<Args...> format, Args&&... args) {
    say(Level::kError, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace obscura::base::log
