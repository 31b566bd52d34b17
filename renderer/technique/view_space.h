// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// What `blizzard` and `raymarch` share: both sample a ball around the point in view space and
/// turn a depth difference into accessibility by the same curve (Jakobsen 2010, 4.3.2.3).
[[nodiscard]] std::vector<Parameter> view_space_parameters();

/// One step with the shader, which reads depth, normal, rotations and a ball of points, and the
/// depth of `depths_per_sample` points for each of them.
[[nodiscard]] Recipe view_space_recipe(const Variant& variant, const std::string& shader,
                                       int depths_per_sample);

/// What both fail by their definition.
[[nodiscard]] std::map<Ideal, std::string> view_space_nature();

/// Both in double precision: the first of `steps` equal steps that finds an occluder counts.
[[nodiscard]] Model view_space_model(int steps);

}  // namespace obscura::renderer
