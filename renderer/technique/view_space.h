// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// What `blizzard` and `raymarch` share: both sample a ball around the point in view space and
/// turn a depth difference into accessibility by the same curve (Jakobsen 2010, 4.3.2.3).
[[nodiscard]] std::vector<Parameter> view_space_parameters();

}  // namespace obscura::renderer
