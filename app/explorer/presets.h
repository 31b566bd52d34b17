// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/explorer/model.h"

namespace obscura::app::explorer {

/// Settings of a technique that have a name.
struct Preset {
    std::string name;
    std::string meaning;  ///< a sentence: where they are from
    renderer::Variant variant;
};

/// Those of the technique: published and fitted values, what papers compare, both with the radius
/// of `now`; and what the study shows.
[[nodiscard]] std::vector<Preset> presets_of(const renderer::Variant& now,
                                             const std::optional<OpenStudy>& study);

}  // namespace obscura::app::explorer
