// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/gpu_scene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "renderer/scene/scene_check.h"

namespace obscura::renderer {
namespace {

/// Whether blur along the view does no harm: the texture tells roughness only, or a surface with
/// holes or seen-through uses it. Leaves are drawn by small cards, some of them edge on; Mesa's
/// software rasterizer filters such with anisotropy without end.
bool may_blur(const Scene& scene, const Texture& texture) {
    const auto index = static_cast<TextureIndex>(&texture - scene.textures.data());
    bool only_roughness = true;
    for (const Material& material : scene.materials) {
        const auto used = textures_of(material);
        const auto uses = std::count(used.begin(), used.end(), index);
        if (uses > 0 && material.coverage != Coverage::kOpaque) return true;
        if (uses > (material.roughness_texture == index ? 1 : 0)) only_roughness = false;
    }
    return only_roughness;
}

[[nodiscard]] GLenum texture_format(const Texture& texture) {
    return texture.srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
}
[[nodiscard]] GLsizei levels_of(const Texture& texture) {
    return static_cast<GLsizei>(
        std::bit_width(static_cast<unsigned>(std::max(texture.width, texture.height))));
}

void set_filter(GLuint name, float anisotropy) {
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameterf(name, GL_TEXTURE_MAX_ANISOTROPY, anisotropy);
}

/// The texels without their finest level, under a filter of their own: that along the view takes
/// two thirds of the time that surfaces take on a software renderer.
gl::Texture coarser_copy(const Texture& texture, GLuint of) {
    gl::Texture copy = gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
    const GLsizei left_out = levels_of(texture) > 1 ? 1 : 0;
    const GLsizei levels = levels_of(texture) - left_out;
    const auto size_at = [&](int size, GLsizei level) { return std::max(1, size >> level); };
    glTextureStorage2D(copy.name(), levels, texture_format(texture),
                       size_at(texture.width, left_out), size_at(texture.height, left_out));
    for (GLsizei level = 0; level < levels; ++level) {
        const GLsizei from = level + left_out;
        glCopyImageSubData(of, GL_TEXTURE_2D, from, 0, 0, 0, copy.name(), GL_TEXTURE_2D, level, 0,
                           0, 0, size_at(texture.width, from), size_at(texture.height, from), 1);
    }
    set_filter(copy.name(), 1.0F);
    return copy;
}

gl::Texture upload(const Scene& scene, const Texture& texture) {
    check_texture(scene, texture);
    gl::Texture result = gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
    glTextureStorage2D(result.name(), levels_of(texture), texture_format(texture), texture.width,
                       texture.height);
    glTextureSubImage2D(result.name(), 0, 0, 0, texture.width, texture.height, GL_RGBA,
                        GL_UNSIGNED_BYTE, texture.rgba.data());
    glGenerateTextureMipmap(result.name());
    set_filter(result.name(), may_blur(scene, texture) ? 1.0F : 4.0F);
    return result;
}

void describe_vertices(GLuint array, GLuint vertices, GLuint indices) {
    glVertexArrayVertexBuffer(array, 0, vertices, 0, sizeof(Vertex));
    glVertexArrayElementBuffer(array, indices);
    struct Attribute {
        GLint components;
        GLenum type;
        GLboolean normalized;
        std::size_t offset;
    };
    const Attribute attributes[] = {
        {3, GL_FLOAT, GL_FALSE, offsetof(Vertex, position_m)},
        {3, GL_FLOAT, GL_FALSE, offsetof(Vertex, normal)},
        {4, GL_FLOAT, GL_FALSE, offsetof(Vertex, tangent)},
        {2, GL_FLOAT, GL_FALSE, offsetof(Vertex, uv)},
        {4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, color)},
    };
    for (GLuint i = 0; i < std::size(attributes); ++i) {
        glEnableVertexArrayAttrib(array, i);
        glVertexArrayAttribFormat(array, i, attributes[i].components, attributes[i].type,
                                  attributes[i].normalized,
                                  static_cast<GLuint>(attributes[i].offset));
        glVertexArrayAttribBinding(array, i, 0);
    }
}

}  // namespace

void GpuScene::draw(const Draw& what, const Frustum& view) {
    std::vector<GLsizei> counts;
    std::vector<const void*> firsts;
    std::size_t end = 0;
    for (const Cluster& cluster : what.clusters) {
        if (!view.may_show(cluster)) continue;
        if (!counts.empty() && cluster.first_index == end) {
            counts.back() += static_cast<GLsizei>(cluster.index_count);
        } else {
            counts.push_back(static_cast<GLsizei>(cluster.index_count));
            firsts.push_back(reinterpret_cast<const void*>(
                (what.first_index + cluster.first_index) * sizeof(std::uint32_t)));
        }
        end = cluster.first_index + cluster.index_count;
    }
    if (counts.empty()) return;
    const std::vector<GLint> bases(counts.size(), what.base_vertex);
    glMultiDrawElementsBaseVertex(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, firsts.data(),
                                  static_cast<GLsizei>(counts.size()), bases.data());
}

GpuScene::GpuScene(const Scene& scene)
    : vertex_array_(gl::VertexArray::make()),
      vertices_(gl::Buffer::make()),
      indices_(gl::Buffer::make()),
      sorted_vertex_array_(gl::VertexArray::make()),
      sorted_indices_(gl::Buffer::make()),
      materials_(scene.materials),
      bounds_(bounds_of(scene)) {
    add_triangles(scene);
    for (const Texture& texture : scene.textures) textures_.push_back(upload(scene, texture));
}

GpuScene::GpuScene(const Scene& coarser, const GpuScene& whole)
    : vertex_array_(gl::VertexArray::make()),
      vertices_(gl::Buffer::make()),
      indices_(gl::Buffer::make()),
      sorted_vertex_array_(gl::VertexArray::make()),
      sorted_indices_(gl::Buffer::make()),
      materials_(coarser.materials),
      bounds_(bounds_of(coarser)) {
    add_triangles(coarser);
    for (std::size_t i = 0; i < coarser.textures.size(); ++i) {
        textures_.push_back(coarser_copy(coarser.textures[i], whole.textures_[i].name()));
    }
}

void GpuScene::add_triangles(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) check_mesh(scene, mesh);
    for (const Material& material : scene.materials) check_textures(scene, material);
    std::size_t vertex_count = 0;
    std::size_t index_count = 0;
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.indices.empty()) continue;
        if (scene.materials[mesh.material].coverage == Coverage::kBlended) {
            add_blended(mesh, vertex_count);
        } else {
            draws_.push_back({static_cast<GLsizei>(mesh.indices.size()), index_count,
                              static_cast<GLint>(vertex_count), mesh.material, clusters_of(mesh)});
        }
        vertex_count += mesh.vertices.size();
        index_count += mesh.indices.size();
    }
    glNamedBufferStorage(
        vertices_.name(),
        static_cast<GLsizeiptr>(std::max<std::size_t>(vertex_count, 1) * sizeof(Vertex)), nullptr,
        GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferStorage(
        indices_.name(),
        static_cast<GLsizeiptr>(std::max<std::size_t>(index_count, 1) * sizeof(std::uint32_t)),
        nullptr, GL_DYNAMIC_STORAGE_BIT);
    GLintptr vertex_offset = 0;
    GLintptr index_offset = 0;
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.indices.empty()) continue;
        const auto vertex_bytes = static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex));
        const auto index_bytes =
            static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t));
        glNamedBufferSubData(vertices_.name(), vertex_offset, vertex_bytes, mesh.vertices.data());
        glNamedBufferSubData(indices_.name(), index_offset, index_bytes, mesh.indices.data());
        vertex_offset += vertex_bytes;
        index_offset += index_bytes;
    }
    describe_vertices(vertex_array_.name(), vertices_.name(), indices_.name());
    if (!blended_.empty()) {
        glNamedBufferStorage(sorted_indices_.name(),
                             static_cast<GLsizeiptr>(3 * blended_.size() * sizeof(std::uint32_t)),
                             nullptr, GL_DYNAMIC_STORAGE_BIT);
        describe_vertices(sorted_vertex_array_.name(), vertices_.name(), sorted_indices_.name());
    }
}

void GpuScene::add_blended(const Mesh& mesh, std::size_t first_vertex) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        BlendedTriangle triangle;
        triangle.material = mesh.material;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t index = mesh.indices[i + corner];
            triangle.indices[corner] = static_cast<std::uint32_t>(first_vertex) + index;
            triangle.middle_m += mesh.vertices[index].position_m / 3.0F;
        }
        blended_.push_back(triangle);
    }
}

}  // namespace obscura::renderer
