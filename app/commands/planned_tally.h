// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/conclusions/analysis.h"
#include "analysis/tally.h"
#include "stimuli/study.h"

namespace obscura::app {

/// The conditions of a study that people vote on, in natural order of their ids as in a tally of
/// answers, with what the study fixes, before anybody answered.
[[nodiscard]] analysis::Tally planned_tally(const stimuli::Study& study);

/// What B is in all of those conditions of a tally, or why it is not one thing.
[[nodiscard]] analysis::Possible<analysis::Pooling> pooling_of(
    const analysis::Tally& tally, const std::vector<std::string>& conditions);

/// Those of the conditions in which what is called A is that B.
[[nodiscard]] std::vector<std::string> turned_in(const analysis::Tally& tally,
                                                 const std::vector<std::string>& conditions);

}  // namespace obscura::app
