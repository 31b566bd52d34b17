// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace obscura::app {

/// What is typed after the program's name with options that have another name since in their place,
/// and a warning for each. To be removed with the version after this one.
[[nodiscard]] std::vector<std::string> with_new_names(const std::vector<std::string>& words);

}  // namespace obscura::app
