// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// Parts of the text report; each is empty or begins with an empty line and ends with a line feed.
[[nodiscard]] std::string verdicts_text(const Analysis& analysis);
[[nodiscard]] std::string power_text(const Possible<RunPower>& power);
[[nodiscard]] std::string attention_text(const Analysis& analysis);
[[nodiscard]] std::string response_times_text(const Analysis& analysis);
[[nodiscard]] std::string exclusions_text(const Analysis& analysis);

}  // namespace obscura::analysis
