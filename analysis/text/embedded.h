// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace obscura::analysis {

/// The bytes of a file compiled into the program, named by its path in analysis/
/// (`data/jakobsen2010.csv`); data() is null where there is no such file.
[[nodiscard]] std::string_view embedded(std::string_view name);

}  // namespace obscura::analysis
