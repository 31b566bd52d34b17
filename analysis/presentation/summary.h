// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// Pairs of which the summary has a line.
inline constexpr std::size_t kMostSummarised = 12;

/// The analysis in one screen: a line for each pair, up to kMostSummarised, and for each verdict;
/// the rest is in text_report(). Ends with a line feed.
[[nodiscard]] std::string summary_text(const Analysis& analysis);

}  // namespace obscura::analysis
