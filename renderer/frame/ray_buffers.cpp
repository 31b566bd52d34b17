// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/ray_buffers.h"

#include <span>

#include "renderer/base/error.h"
#include "renderer/reference/ray_scene.h"
#include "renderer/reference/ray_tree.h"
#include "renderer/reference/reference.h"

namespace obscura::renderer {
namespace {

template <typename Value>
gl::Buffer stored(const std::vector<Value>& values) {
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    const std::size_t bytes = values.size() * sizeof(Value);
    if (bytes > static_cast<std::size_t>(most)) {
        throw base::failure("the scene's rays need a buffer of {} bytes, and the driver allows {}",
                            bytes, most);
    }
    gl::Buffer buffer = gl::Buffer::make();
    // A shader may name what is empty.
    constexpr Value kNothing{};
    glNamedBufferStorage(buffer.name(),
                         static_cast<GLsizeiptr>(values.empty() ? sizeof(Value) : bytes),
                         values.empty() ? &kNothing : values.data(), 0);
    return buffer;
}

}  // namespace

RayBuffers::RayBuffers(const ReferenceScene& scene)
    : origin_m_(scene.rays().origin_m()), scene_(scene.rays().number()) {
    const RayTree tree = ray_tree(scene.rays());
    buffers_ = {stored(tree.nodes), stored(tree.triangles), stored(tree.cut_outs),
                stored(tree.alpha)};
}

bool RayBuffers::is_of(const ReferenceScene& scene) const {
    return scene_ == scene.rays().number();
}

void RayBuffers::bind() const {
    GLuint binding = 0;
    for (const gl::Buffer& buffer : buffers_) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer.name());
    }
}

}  // namespace obscura::renderer
