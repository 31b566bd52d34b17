// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// One scale for each group of variants that pairs with votes connect, in the order in which the
/// conditions name them. The reference is the variant None where the group has it, otherwise the
/// one named first. Where the order of showing is known and the votes settle it, there is a term
/// for it; where participants are known, errors are over them, and there are none of fewer than
/// kFewestForMeans. Votes that separate get the scale that is likeliest under a prior.
[[nodiscard]] std::vector<VariantScale> variant_scales(const Tally& tally);

}  // namespace obscura::analysis
