// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "app/commands/command.h"

namespace obscura::app {

/// The word STUDY of a command; `otherwise` says what is meant without it.
Option add_study(const Options& app, std::string& study,
                 std::string_view otherwise = "jakobsen2010");

/// What the word leads to: a study file or a built-in study as it is; of a package the study file
/// that it was unpacked to, below the data folder, where its images lie in their place too. Throws
/// bad input as stimuli::unpack does.
[[nodiscard]] std::string study_named(const std::string& word, const Globals& globals);

}  // namespace obscura::app
