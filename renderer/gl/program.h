// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "renderer/gl/handles.h"

namespace obscura::renderer::gl {

/// Shaders, compiled and linked. Sources are named by their path below renderer/: embedded in the
/// program, or read from the folder in OBSCURA_SHADERS where that is set. A line `#include "path"`
/// is replaced by that file, once.
class Program {
  public:
    /// A vertex and a fragment shader. Every define becomes `#define TEXT` at the top of both.
    /// Throws failure with the shader's name and the driver's log.
    Program(const std::string& vertex, const std::string& fragment,
            const std::vector<std::string>& defines);
    /// A compute shader that does what the fragment shader does when it is drawn over a whole
    /// image: compute_source(). Throws likewise.
    [[nodiscard]] static Program computing(const std::string& fragment,
                                           const std::vector<std::string>& defines);

    void use() const;
    /// The fragment shader's path.
    [[nodiscard]] const std::string& name() const { return name_; }
    /// Whether the compiled program uses a uniform of that name.
    [[nodiscard]] bool has(const std::string& uniform) const { return active_.contains(uniform); }
    /// The uniforms that the program uses and nobody has set yet; each is given once.
    [[nodiscard]] std::vector<std::string> newly_unset();
    // A uniform that the shader does not use is ignored, as the compiler may have removed it.
    void set(const char* uniform, int value);
    void set(const char* uniform, float value);
    void set(const char* uniform, const glm::vec2& value);
    void set(const char* uniform, const glm::vec3& value);
    void set(const char* uniform, const glm::mat3& value);
    void set(const char* uniform, const glm::mat4& value);
    void set(const char* uniform, std::span<const glm::vec3> values);
    void set(const char* uniform, std::span<const glm::mat4> values);

  private:
    explicit Program(const std::string& name);
    void link(std::span<const Shader> shaders);
    [[nodiscard]] GLint location(const char* uniform);

    ProgramName program_;
    std::unordered_map<std::string, GLint> locations_;  ///< of all that were set
    std::string name_;
    std::set<std::string> active_;
    bool checked_ = false;
};

/// The folder in OBSCURA_SHADERS, from which shaders are read; empty where it is unset or empty.
[[nodiscard]] std::string shader_folder();

/// The text of a shader file with its includes in place. Throws failure naming what is missing.
[[nodiscard]] std::string shader_source(const std::string& path);

/// Texels along the sides of what one work group of a computing program writes.
inline constexpr glm::ivec2 kWorkGroup{16, 8};

/// The text of a fragment shader that reads `gl_FragCoord.xy`, writes one `out` variable and never
/// discards, as a compute shader that writes the same to the image `o_image`. With the define
/// SURFACES it writes ones where the depth buffer `t_covered` has no triangle. Throws failure
/// naming the shader where it has not just one output.
[[nodiscard]] std::string compute_source(const std::string& fragment, const std::string& name);

}  // namespace obscura::renderer::gl
