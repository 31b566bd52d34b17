// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::stimuli {

/// One side of a condition as it is to become.
struct VariantChange {
    std::string condition;
    char side = 'a';  ///< a or b
    renderer::TechniqueChoice choice;
};

/// The text of a study file with those sides replaced by inline tables; everything else, comments
/// too, stays as it is. Numbers are written in full. Throws bad input naming `name` for a text that
/// is no TOML, or that has not such a condition.
[[nodiscard]] std::string with_variants(std::string_view text, const std::string& name,
                                        const std::vector<VariantChange>& changes);

}  // namespace obscura::stimuli
