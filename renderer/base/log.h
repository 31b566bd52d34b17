// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <spdlog/spdlog.h>

namespace obscura::base {

/// Sends spdlog to stderr, without time stamps; `quiet` leaves warnings and errors only.
/// Use as spdlog::info(...), spdlog::warn(...), spdlog::error(...).
void set_up_log(bool quiet);

}  // namespace obscura::base
