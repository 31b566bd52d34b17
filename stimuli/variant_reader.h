// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "renderer/technique/technique.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// Reads one side of a condition: `technique`, `samples` (standard: the technique's), `denoise`
/// (standard: separable for a technique that a shader computes, else none) and the technique's own
/// parameters. Notes what is wrong, each at its key's line.
[[nodiscard]] renderer::TechniqueChoice read_variant(const toml::table& table,
                                                     const std::string& where,
                                                     std::vector<StudyProblem>& problems);

/// Whether both make the same accessibility: technique, samples, denoise and every parameter agree,
/// those at their standard value too.
[[nodiscard]] bool same_variant(const renderer::TechniqueChoice& a,
                                const renderer::TechniqueChoice& b);

}  // namespace obscura::stimuli
