// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// A table for people, with what was tested in words. Ends with a line feed.
[[nodiscard]] std::string text_report(const Analysis& analysis);

}  // namespace obscura::analysis
