// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace obscura::stimuli {

/// The bytes of a file compiled into the program, named by its path in stimuli/
/// (`studies/jakobsen2010.toml`); data() is null where there is no such file.
[[nodiscard]] std::string_view embedded(std::string_view name);

/// The names of all such files.
[[nodiscard]] std::vector<std::string_view> embedded_names();

}  // namespace obscura::stimuli
