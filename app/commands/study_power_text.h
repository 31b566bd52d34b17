// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/commands/power_of_study.h"

namespace obscura::app {

/// What power_of_study() found, as a table with what was simulated.
[[nodiscard]] std::string study_power_text(const stimuli::Study& study, const PowerRequest& request,
                                           const std::vector<VerdictPower>& results);

/// The same as JSON.
[[nodiscard]] std::string study_power_json(const stimuli::Study& study, const PowerRequest& request,
                                           const std::vector<VerdictPower>& results);

}  // namespace obscura::app
