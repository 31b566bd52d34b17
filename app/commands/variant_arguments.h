// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "renderer/technique/technique.h"
#include "renderer/technique/variant.h"

namespace obscura::app {

/// A variant as a command line says it.
struct VariantArguments {
    std::string technique;
    std::optional<int> samples;         ///< the technique's standard
    std::vector<std::string> settings;  ///< KEY=VALUE of parameters and options
    std::string denoise = "none";
    std::string preset = "published";
    std::optional<double> radius_m =
        {};  ///< of the technique, where it has one; --set radius_m wins
};

/// --samples, --set, --radius, --preset and --denoise; the technique is the command's own.
void add_variant_options(const Options& app, VariantArguments& arguments);

/// The technique that --technique names. Throws bad input with those that there are.
[[nodiscard]] const renderer::Technique& technique_named(const std::string& name);

/// Throws bad input naming every option that is wrong, with its value and what is allowed.
[[nodiscard]] renderer::Variant variant_from(const VariantArguments& arguments);

}  // namespace obscura::app
