// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

#include "renderer/gl/handles.h"

namespace obscura::renderer {

class ReferenceScene;

/// A scene's triangles for rays on the GPU: the storage buffers of technique/rays.glsl. Needs a
/// current context for as long as it lives.
class RayBuffers {
  public:
    explicit RayBuffers(const ReferenceScene& scene);

    void bind() const;
    [[nodiscard]] const glm::dvec3& origin_m() const { return origin_m_; }
    /// Whether it was made of that very scene.
    [[nodiscard]] bool is_of(const ReferenceScene& scene) const;

  private:
    std::array<gl::Buffer, 4> buffers_;
    glm::dvec3 origin_m_;
    std::size_t scene_;
};

}  // namespace obscura::renderer
