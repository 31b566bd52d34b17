// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/measurement/hard_case_table.h"
#include "app/measure/request.h"

namespace obscura::app {

/// The hard cases of the techniques (the request's, or all), then those of the statistics. Needs a
/// current OpenGL context.
[[nodiscard]] std::vector<analysis::HardCaseRow> run_all_hard_cases(const MeasureRequest& request);

/// How a technique comes off in the hard cases.
struct HardCaseCount {
    int held = 0;
    int by_nature = 0;
    int rows = 0;  ///< in all
};

/// Of each technique that computes a buffer, without the rows that compare times. Needs a current
/// OpenGL context.
[[nodiscard]] std::map<std::string, HardCaseCount> count_hard_cases(
    const std::vector<std::string>& techniques, bool quiet);

}  // namespace obscura::app
