// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/questions.h"

namespace obscura::analysis {

/// JSON with numbers in full precision; a value that does not exist is null, and beside NAME stands
/// NAME_reason. `questions` where more was asked than the pairs. Ends with a line feed.
[[nodiscard]] std::string json_report(const Analysis& analysis,
                                      const QuestionsResult* questions = nullptr);

}  // namespace obscura::analysis
