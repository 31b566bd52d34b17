// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "renderer/recipe/recipe.h"

namespace obscura::renderer {

/// Lets the steps of a technique write, and those of a filter read, depth beside the accessibility
/// in one buffer, where all of them can and its format is as exact: what the filter needs both of
/// is then fetched once. Says whether; otherwise both recipes stay as they are.
[[nodiscard]] bool lay_depth_beside(std::string_view ao_format, Recipe& technique, Recipe& filter);

}  // namespace obscura::renderer
