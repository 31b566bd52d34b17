// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/commands/options.h"

namespace obscura::app {

/// The shells that completion is written for: bash, zsh, fish.
[[nodiscard]] const std::vector<std::string>& known_shells();

/// What `--completion SHELL` or `--manual` asks for; empty where the words ask for neither. Throws
/// bad input for a shell that is not known.
[[nodiscard]] std::string manual_or_completion(const std::vector<std::string>& words,
                                               const DescribedCommand& program);

}  // namespace obscura::app
