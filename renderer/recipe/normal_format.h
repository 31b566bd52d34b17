// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string_view>

namespace obscura::renderer {

/// How a normal is stored: one of Variant::normal_format. passes/normal_codec.glsl reads the
/// define.
struct NormalFormat {
    const char* name;
    const char* buffer;  ///< its buffer's format
    const char* define;  ///< for shaders that decode it; empty: none
    int channels;        ///< that hold the code
    int most;            ///< the largest code of a channel
};

/// That of a name; `from-depth` is stored as oct16. The name must be one of the option's.
[[nodiscard]] const NormalFormat& normal_format_of(std::string_view name);

/// The unit vector of codes in [0, 1], in single precision.
[[nodiscard]] glm::vec3 decoded_normal(const NormalFormat& format, const glm::vec3& code);

}  // namespace obscura::renderer
