// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/export/export.h"

namespace obscura::analysis {

/// Fills ExportOptions::left_out and tests from the analysis of every study and kind of the store's
/// completed sessions, with the views of ExportOptions::studies; `url` stands for the store in
/// messages. Both are of the export's moment only within one Store::of_one_moment with it. Gives,
/// in sentences, what cannot be analysed and so is not known. Keeps the answers in memory, some 60
/// MB for a million.
[[nodiscard]] std::vector<std::string> add_conclusions(ExportOptions& options, Store& store,
                                                       const std::string& url);

}  // namespace obscura::analysis
