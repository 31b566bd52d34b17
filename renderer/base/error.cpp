// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"

#include <fmt/format.h>

namespace obscura::base {

Error formatted_error(ExitCode code, fmt::string_view format, fmt::format_args args) {
    return {code, fmt::vformat(format, args)};
}

}  // namespace obscura::base
