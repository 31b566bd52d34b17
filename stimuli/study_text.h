// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::stimuli {

/// As TOML writes a string on one line.
[[nodiscard]] std::string quoted(const std::string& text);

}  // namespace obscura::stimuli
