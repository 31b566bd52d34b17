// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/gl/program.h"

#include <cstdlib>
#include <filesystem>
#include <glm/gtc/type_ptr.hpp>
#include <set>
#include <sstream>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/gl/embedded_shaders.h"

namespace obscura::renderer::gl {
namespace {

std::string read_shader(const std::string& path) {
    if (const std::string folder = shader_folder(); !folder.empty()) {
        return base::read_file(std::filesystem::path(folder) / path);
    }
    const std::string_view text = shaders::embedded(path);
    if (text.data() == nullptr) {
        throw base::failure("the shader {} is not part of this program", path);
    }
    return std::string(text);
}

void expand(const std::string& path, std::set<std::string>& seen, std::string& out) {
    if (!seen.insert(path).second) return;
    std::istringstream lines(read_shader(path));
    // The driver names lines by number of file and line; the first file is 1.
    const std::size_t file = seen.size();
    int number = 0;
    out += fmt::format("#line 1 {}\n", file);
    for (std::string line; std::getline(lines, line);) {
        ++number;
        constexpr std::string_view kInclude = "#include \"";
        if (line.starts_with(kInclude)) {
            const std::size_t end = line.find('"', kInclude.size());
            expand(line.substr(kInclude.size(), end - kInclude.size()), seen, out);
            out += fmt::format("#line {} {}\n", number + 1, file);
        } else {
            out += line + '\n';
        }
    }
}

Shader compile(GLenum stage, const std::string& path, const std::vector<std::string>& defines) {
    std::string text = "#version 450 core\n";
    for (const std::string& define : defines) text += "#define " + define + '\n';
    text += shader_source(path);
    Shader shader = Shader::make(stage);
    const char* pointer = text.c_str();
    glShaderSource(shader.name(), 1, &pointer, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        char log[4096] = "";
        glGetShaderInfoLog(shader.name(), sizeof log, nullptr, log);
        throw base::failure("the shader {} does not compile:\n{}", path, log);
    }
    return shader;
}

}  // namespace

std::string shader_folder() {
    const char* folder = std::getenv("OBSCURA_SHADERS");
    return folder != nullptr ? folder : "";
}

std::string shader_source(const std::string& path) {
    std::set<std::string> seen;
    std::string text;
    expand(path, seen, text);
    return text;
}

Program::Program(const std::string& vertex, const std::string& fragment,
                 const std::vector<std::string>& defines)
    : program_(ProgramName::make()), name_(fragment) {
    const Shader vertex_shader = compile(GL_VERTEX_SHADER, vertex, defines);
    const Shader fragment_shader = compile(GL_FRAGMENT_SHADER, fragment, defines);
    glAttachShader(program_.name(), vertex_shader.name());
    glAttachShader(program_.name(), fragment_shader.name());
    glLinkProgram(program_.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        char log[4096] = "";
        glGetProgramInfoLog(program_.name(), sizeof log, nullptr, log);
        throw base::failure("the shaders {} and {} do not link:\n{}", vertex, fragment, log);
    }
    GLint count = 0;
    glGetProgramiv(program_.name(), GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char name[256] = "";
        glGetActiveUniformName(program_.name(), static_cast<GLuint>(i), sizeof name, nullptr, name);
        const std::string uniform = name;
        active_.insert(uniform.substr(0, uniform.find('[')));
    }
}

std::vector<std::string> Program::newly_unset() {
    std::vector<std::string> unset;
    if (std::exchange(checked_, true)) return unset;
    for (const std::string& uniform : active_) {
        if (!locations_.contains(uniform)) unset.push_back(uniform);
    }
    return unset;
}

void Program::use() const { glUseProgram(program_.name()); }

GLint Program::location(const char* uniform) {
    const auto found = locations_.find(uniform);
    if (found != locations_.end()) return found->second;
    const GLint location = glGetUniformLocation(program_.name(), uniform);
    locations_.emplace(uniform, location);
    return location;
}

void Program::set(const char* uniform, int value) {
    glProgramUniform1i(program_.name(), location(uniform), value);
}
void Program::set(const char* uniform, float value) {
    glProgramUniform1f(program_.name(), location(uniform), value);
}
void Program::set(const char* uniform, const glm::vec2& value) {
    glProgramUniform2fv(program_.name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec3& value) {
    glProgramUniform3fv(program_.name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat3& value) {
    glProgramUniformMatrix3fv(program_.name(), location(uniform), 1, GL_FALSE,
                              glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) {
    glProgramUniformMatrix4fv(program_.name(), location(uniform), 1, GL_FALSE,
                              glm::value_ptr(value));
}
void Program::set(const char* uniform, std::span<const glm::vec3> values) {
    glProgramUniform3fv(program_.name(), location(uniform), static_cast<GLsizei>(values.size()),
                        reinterpret_cast<const GLfloat*>(values.data()));
}
void Program::set(const char* uniform, std::span<const glm::mat4> values) {
    glProgramUniformMatrix4fv(program_.name(), location(uniform),
                              static_cast<GLsizei>(values.size()), GL_FALSE,
                              reinterpret_cast<const GLfloat*>(values.data()));
}

}  // namespace obscura::renderer::gl
