// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/conclusions/analysis.h"

namespace obscura::analysis {

/// Which models are fitted.
enum class ScaleParts { kBoth, kThurstone };

/// One scale for each group of variants that pairs with votes connect, in the order in which the
/// conditions name them. The reference is the variant None where the group has it, otherwise the
/// one named first.
[[nodiscard]] std::vector<VariantScale> variant_scales(const Tally& tally,
                                                       ScaleParts parts = ScaleParts::kBoth);

}  // namespace obscura::analysis
