// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/explorer/fitted_values.h"
#include "app/explorer/model.h"

namespace obscura::app::explorer {

/// Settings of a technique that have a name.
struct Preset {
    std::string name;
    std::string meaning;  ///< a sentence: where they are from
    renderer::Variant variant;
};

/// Those of the technique: published and fitted values, what papers compare, all with the radius
/// of `now`; what was `fitted` on the scene of that id, with the radius of that fit where it moved
/// it; and what the study shows.
[[nodiscard]] std::vector<Preset> presets_of(const renderer::Variant& now,
                                             const std::optional<OpenStudy>& study,
                                             const std::vector<FittedValues>& fitted = {},
                                             const std::string& scene = "");

}  // namespace obscura::app::explorer
