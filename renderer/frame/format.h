// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <string_view>

namespace obscura::renderer {

/// How the texels of a buffer are stored.
struct Format {
    const char* name;  ///< as a Buffer says it
    std::size_t bytes_per_texel;
    GLenum internal;
    GLenum format;  ///< of its stored bytes
    GLenum type;
};

[[nodiscard]] int components_of(const Format& format);

/// Whether a shader can store to images of that format (OpenGL 4.5, table 8.26).
[[nodiscard]] bool can_be_stored(const Format& format);

/// Throws failure naming those there are.
[[nodiscard]] const Format& format_of(std::string_view name);

}  // namespace obscura::renderer
