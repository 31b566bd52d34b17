// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/colour.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace obscura::base {

bool shows_colour() {
    const char* const unwanted = std::getenv("NO_COLOR");
    const char* const terminal = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) != 0 && (unwanted == nullptr || *unwanted == '\0') &&
           terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace obscura::base
