// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace obscura::renderer {

class RayScene;

/// A scene's triangles in a binary bounding volume hierarchy, as technique/rays.glsl reads it from
/// storage buffers. Coordinates are relative to RayScene::origin_m(); floats are stored as their
/// bits.
struct RayTree {
    /// Four a node: lower corner and number of the first child, upper corner and number of the
    /// second; lower and upper corner of the second child. A child's number is that of its node, or
    /// kLeaf with its triangles: how many << kCountShift, and the first.
    std::vector<glm::uvec4> nodes;
    /// Three a triangle: a corner and the cut-out (0: none, else its number + 1); the edge to the
    /// second corner and whether its back is not drawn; the edge to the third.
    std::vector<glm::uvec4> triangles;
    /// Three a triangle of a cut-out: the texture coordinates of two corners; of the third,
    /// opacity, alpha cutoff; its first texel in `alpha`, width, height (0: none).
    std::vector<glm::uvec4> cut_outs;
    std::vector<std::uint32_t> alpha;  ///< four texels each, the first in the lowest bits

    static constexpr std::uint32_t kLeaf = 1U << 31;
    static constexpr int kCountShift = 28;
    static constexpr int kMostInLeaf = 4;
    static constexpr int kDepth = 60;  ///< most nodes on a way down

    [[nodiscard]] std::size_t bytes() const;
};

/// Built by Embree's builder with a surface area heuristic, on all cores. Throws failure where
/// memory runs out or the scene has 2^28 triangles.
[[nodiscard]] RayTree ray_tree(const RayScene& scene);

}  // namespace obscura::renderer
