// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/technique/variant.h"

namespace obscura::stimuli {

/// Settings that a paper compares under a name. Radii are a scene's own and are left as they are
/// by default; what the paper's parameters have no counterpart of here stays at its standard.
struct PaperConfiguration {
    std::string name;     ///< `Hussain 2021, performance`
    std::string meaning;  ///< a sentence: where it is from
    renderer::Variant variant;
};
[[nodiscard]] const std::vector<PaperConfiguration>& paper_configurations();

/// The variant of that name and technique. Throws failure where there is none.
[[nodiscard]] const renderer::Variant& paper_variant(const std::string& name,
                                                     const std::string& technique);

}  // namespace obscura::stimuli
