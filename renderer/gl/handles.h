// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace obscura::renderer::gl {

/// Owns one OpenGL name; `Traits` knows how to make and delete it. Movable, not copyable. A context
/// must be current whenever one is made or destroyed.
template <typename Traits>
class Handle {
  public:
    Handle() = default;
    template <typename... Args>
    static Handle make(Args... args) {
        Handle handle;
        handle.name_ = Traits::make(args...);
        return handle;
    }
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (name_ != 0) Traits::remove(name_);
    }
    [[nodiscard]] GLuint name() const { return name_; }
    [[nodiscard]] explicit operator bool() const { return name_ != 0; }

  private:
    GLuint name_ = 0;
};

struct TextureTraits {
    static GLuint make(GLenum target) {
        GLuint name = 0;
        glCreateTextures(target, 1, &name);
        return name;
    }
    static void remove(GLuint name) { glDeleteTextures(1, &name); }
};
struct BufferTraits {
    static GLuint make() {
        GLuint name = 0;
        glCreateBuffers(1, &name);
        return name;
    }
    static void remove(GLuint name) { glDeleteBuffers(1, &name); }
};
struct FramebufferTraits {
    static GLuint make() {
        GLuint name = 0;
        glCreateFramebuffers(1, &name);
        return name;
    }
    static void remove(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayTraits {
    static GLuint make() {
        GLuint name = 0;
        glCreateVertexArrays(1, &name);
        return name;
    }
    static void remove(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct QueryTraits {
    static GLuint make(GLenum target) {
        GLuint name = 0;
        glCreateQueries(target, 1, &name);
        return name;
    }
    static void remove(GLuint name) { glDeleteQueries(1, &name); }
};
struct ShaderTraits {
    static GLuint make(GLenum stage) { return glCreateShader(stage); }
    static void remove(GLuint name) { glDeleteShader(name); }
};
struct ProgramTraits {
    static GLuint make() { return glCreateProgram(); }
    static void remove(GLuint name) { glDeleteProgram(name); }
};

using Texture = Handle<TextureTraits>;
using Buffer = Handle<BufferTraits>;
using Framebuffer = Handle<FramebufferTraits>;
using VertexArray = Handle<VertexArrayTraits>;
using Shader = Handle<ShaderTraits>;
using Query = Handle<QueryTraits>;
using ProgramName = Handle<ProgramTraits>;

}  // namespace obscura::renderer::gl
