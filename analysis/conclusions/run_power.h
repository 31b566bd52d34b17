// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// What the votes of the conditions could show. No value without votes and for more votes than
/// kMostParticipants.
[[nodiscard]] Possible<RunPower> run_power(const std::vector<ConditionResult>& conditions);

}  // namespace obscura::analysis
