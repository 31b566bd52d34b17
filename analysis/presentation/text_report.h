// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/conclusions/caveats.h"

namespace obscura::analysis {

/// A table for people, with what was tested in words, and what to know before believing it. Ends
/// with a line feed.
[[nodiscard]] std::string text_report(const Analysis& analysis,
                                      const std::vector<Caveat>& caveats = {});

}  // namespace obscura::analysis
