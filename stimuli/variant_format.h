// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "renderer/technique/variant.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// Reads one side of a condition: `technique`, `samples` (standard: the technique's), `denoise`
/// (standard: renderer::standard_denoise), the options of every variant and the technique's own
/// parameters. Notes what is wrong, each at its key's line.
[[nodiscard]] renderer::Variant read_variant(const toml::table& table, const std::string& where,
                                             std::vector<StudyProblem>& problems);

/// As TOML writes a float: with a point or an exponent, exactly.
[[nodiscard]] std::string toml_float(double value);

/// An inline table that read_variant reads as the same variant.
[[nodiscard]] std::string to_toml(const renderer::Variant& variant);

/// Adds the variant to an object: technique, samples, parameters (all of them), denoise, and the
/// options that are not at their standard.
void put_variant(nlohmann::ordered_json& object, const renderer::Variant& variant);

/// What put_variant added. Throws nlohmann-json's exception for what is missing or of another type.
[[nodiscard]] renderer::Variant variant_from(const nlohmann::ordered_json& object);

}  // namespace obscura::stimuli
