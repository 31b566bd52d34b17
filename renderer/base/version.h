// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::base {

/// The program with its version, `obscura 0.1.0`: what files that it writes say of it.
[[nodiscard]] std::string program_version();

}  // namespace obscura::base
