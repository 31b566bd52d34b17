// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// A point in the unit ball and its share of its set's occlusion.
struct WeightedPoint {
    glm::vec3 point;
    double weight;
};

/// The two sets of `starcraft2`, the weights of each adding up to 1: the wide one, and, where there
/// is a small radius and points enough, a quarter of them around which it lies.
struct Starcraft2Points {
    std::vector<WeightedPoint> wide;
    std::vector<WeightedPoint> small;
};
[[nodiscard]] Starcraft2Points starcraft2_points(const Variant& variant);

/// How often each side of the depth that `starcraft2` looks occluders up in is halved: 0 to 2.
[[nodiscard]] int starcraft2_halvings(const Variant& variant);

/// The definition of `starcraft2` in double precision.
[[nodiscard]] PixelModel starcraft2_model(const SeenBuffers& buffers, const Variant& variant);

}  // namespace obscura::renderer
