// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/light/shadow.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// Triangles of a mesh that follow each other, and the box around them. Those in view, drawn in
/// their order, make the image that the whole mesh makes, to the byte.
struct Cluster {
    Bounds box;
    std::size_t first_index = 0;  ///< of the mesh's
    std::size_t index_count = 0;
    bool bounded = true;  ///< false: some coordinate is no finite number; drawn always
};
inline constexpr std::size_t kClusterTriangles = 256;

[[nodiscard]] std::vector<Cluster> clusters_of(const Mesh& mesh);

/// What a camera sees, as six half-spaces.
class Frustum {
  public:
    explicit Frustum(const CameraMatrices& camera);

    /// False only where nothing in the box can be in the image, whatever single precision does to
    /// its vertices.
    [[nodiscard]] bool may_show(const Cluster& cluster) const;

  private:
    struct HalfSpace {
        glm::dvec3 normal;
        double offset = 0.0;
    };
    std::array<HalfSpace, 6> sides_;
    glm::dvec3 eye_m_;
};

}  // namespace obscura::renderer
