// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/presentation/report.h"

namespace obscura::analysis {

// Paragraphs for a paper, plain text with citations as `[@key]` (references.bib). Every number in
// them is the analysis's own, so that they say what the report says.

/// What was done: who, what was shown and asked, in which order, whom a rule left out, the tests.
[[nodiscard]] std::vector<std::string> method_paragraphs(const ReportInput& input);

/// What came out: the pairs, each verdict, the order of showing.
[[nodiscard]] std::vector<std::string> result_paragraphs(const ReportInput& input);

}  // namespace obscura::analysis
