// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/measurement/overview.h"
#include "analysis/measurement/row.h"
#include "app/measure/experiment.h"
#include "app/measure/hard_cases.h"

namespace obscura::app {

/// The means of each setting over its views, with ratios and front. `rows` hold all settings of one
/// view after the other, in the settings' order; `hard_cases` are by technique.
[[nodiscard]] std::vector<analysis::OverviewRow> overview_of(
    const std::vector<analysis::MeasurementRow>& rows,
    const std::vector<Experiment::Setting>& settings,
    const std::map<std::string, HardCaseCount>& hard_cases);

/// The techniques of the settings that compute a buffer, each once.
[[nodiscard]] std::vector<std::string> techniques_of(
    const std::vector<Experiment::Setting>& settings);

}  // namespace obscura::app
