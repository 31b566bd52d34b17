// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "renderer/frame/clusters.h"
#include "renderer/gl/handles.h"
#include "renderer/light/shadow.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// A scene's triangles and textures on the GPU. Needs a current context for as long as it lives.
class GpuScene {
  public:
    /// Throws bad input naming mesh and index where an index or material is out of range.
    explicit GpuScene(const Scene& scene);
    /// A coarser scene with the textures of the whole one, at half their size and filtered more
    /// cheaply, for images that are seen for a moment. Both have the same materials and textures.
    GpuScene(const Scene& coarser, const GpuScene& whole);

    struct Draw {
        GLsizei index_count = 0;
        std::size_t first_index = 0;
        GLint base_vertex = 0;
        std::uint32_t material = 0;
        std::vector<Cluster> clusters = {};
    };
    /// A triangle that is seen through; its indices count all of the scene's vertices.
    struct BlendedTriangle {
        glm::vec3 middle_m{0.0F};
        std::array<std::uint32_t, 3> indices{};
        std::uint32_t material = 0;
    };
    [[nodiscard]] GLuint vertex_array() const { return vertex_array_.name(); }
    /// Draws it; the vertex array must be bound.
    static void draw(const Draw& what) {
        glDrawElementsBaseVertex(
            GL_TRIANGLES, what.index_count, GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(what.first_index * sizeof(std::uint32_t)),
            what.base_vertex);
    }
    /// The same without what is out of view.
    static void draw(const Draw& what, const Frustum& view);
    /// Everything that is not blended.
    [[nodiscard]] const std::vector<Draw>& draws() const { return draws_; }
    [[nodiscard]] const std::vector<BlendedTriangle>& blended() const { return blended_; }
    /// The same vertices under an index buffer of their own, for triangles in another order.
    [[nodiscard]] GLuint sorted_vertex_array() const { return sorted_vertex_array_.name(); }
    [[nodiscard]] GLuint sorted_indices() const { return sorted_indices_.name(); }
    [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }
    [[nodiscard]] GLuint texture(TextureIndex index) const { return textures_[index].name(); }
    [[nodiscard]] const Bounds& bounds() const { return bounds_; }

  private:
    void add_triangles(const Scene& scene);
    void add_blended(const Mesh& mesh, std::size_t first_vertex);

    gl::VertexArray vertex_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    gl::VertexArray sorted_vertex_array_;
    gl::Buffer sorted_indices_;
    std::vector<gl::Texture> textures_;
    std::vector<Draw> draws_;
    std::vector<BlendedTriangle> blended_;
    std::vector<Material> materials_;
    Bounds bounds_;
};

}  // namespace obscura::renderer
