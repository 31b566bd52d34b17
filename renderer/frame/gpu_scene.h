// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/light/shadow.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// A scene's triangles and textures on the GPU. Needs a current context for as long as it lives.
class GpuScene {
  public:
    /// Throws bad input naming mesh and index where an index or material is out of range.
    explicit GpuScene(const Scene& scene);

    struct Draw {
        GLsizei index_count = 0;
        std::size_t first_index = 0;
        GLint base_vertex = 0;
        std::uint32_t material = 0;
    };
    [[nodiscard]] GLuint vertex_array() const { return vertex_array_.name(); }
    [[nodiscard]] const std::vector<Draw>& draws() const { return draws_; }
    [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }
    [[nodiscard]] GLuint texture(TextureIndex index) const { return textures_[index].name(); }
    [[nodiscard]] const Bounds& bounds() const { return bounds_; }

  private:
    gl::VertexArray vertex_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    std::vector<gl::Texture> textures_;
    std::vector<Draw> draws_;
    std::vector<Material> materials_;
    Bounds bounds_;
};

}  // namespace obscura::renderer
