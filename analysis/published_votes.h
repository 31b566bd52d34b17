// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/tally.h"

namespace obscura::analysis {

/// The votes of Jakobsen 2010, Table 4, as they ship in analysis/data/jakobsen2010.csv.
[[nodiscard]] Tally published_votes();

}  // namespace obscura::analysis
