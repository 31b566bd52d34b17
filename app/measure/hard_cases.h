// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/measurement/hard_case_table.h"
#include "app/measure/request.h"

namespace obscura::app {

/// The hard cases of the techniques (the request's, or all), then those of the statistics. Needs a
/// current OpenGL context.
[[nodiscard]] std::vector<analysis::HardCaseRow> run_all_hard_cases(const MeasureRequest& request);

}  // namespace obscura::app
