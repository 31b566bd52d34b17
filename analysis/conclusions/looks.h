// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/statistics/alpha_spending.h"
#include "analysis/statistics/possible.h"
#include "analysis/tally.h"

namespace obscura::analysis {

/// Which look at a study's answers an analysis is.
struct LookResult {
    std::vector<std::int64_t> looks;  ///< participants at each so far, this one last
    std::vector<std::int64_t> planned;
    Spending spending = Spending::kNone;
    LookBoundary boundary;    ///< of a test alone; without spending that of the level
    bool is_planned = false;  ///< at just so many participants as the study planned
    bool is_interim = false;  ///< more participants are planned
    /// How often a test at .05 finds something at one of these looks where nothing is; where looks
    /// are spent for, .05.
    double error = 0.0;
    std::string words;  ///< all of this, in sentences

    /// What stands in the place of a p-value at this look.
    [[nodiscard]] double spent(double p) const;
};

/// No value, with the reason, where the study plans no looks and this is the first that is known.
[[nodiscard]] Possible<LookResult> look_of(const Tally& tally);

}  // namespace obscura::analysis
