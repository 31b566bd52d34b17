// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/model/model.h"

namespace obscura::renderer {

/// `count` points of the hemisphere about +Z, their directions spread with the cosine's density (a
/// disc of evenly spread points, lifted: Malley's method), their lengths evenly from `shortest` to
/// 1 in an order that is none of the directions'.
[[nodiscard]] std::vector<glm::vec3> hemisphere_kernel(int count, double shortest);

/// The definition of `hemisphere` in double precision.
[[nodiscard]] PixelModel hemisphere_model(const SeenBuffers& buffers, const Variant& variant);

}  // namespace obscura::renderer
