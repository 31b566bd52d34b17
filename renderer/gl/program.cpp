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

Shader compile(GLenum stage, const std::string& path, const std::string& source,
               const std::vector<std::string>& defines) {
    std::string text = "#version 450 core\n";
    for (const std::string& define : defines) text += "#define " + define + '\n';
    text += source;
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

void replace_all(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos;
         at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
}

constexpr const char* kBeforeComputing = R"(
layout(local_size_x = {}, local_size_y = {}) in;
writeonly uniform image2D o_image;
#ifdef SURFACES
uniform sampler2D t_covered;
#endif
vec4 texel_place;
vec4 widened(float v) {{ return vec4(v, 0.0, 0.0, 1.0); }}
vec4 widened(vec2 v) {{ return vec4(v, 0.0, 1.0); }}
vec4 widened(vec3 v) {{ return vec4(v, 1.0); }}
vec4 widened(vec4 v) {{ return v; }}
)";
constexpr const char* kAfterFragment = R"(
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(o_image)))) return;
    texel_place = vec4(vec2(at) + 0.5, 0.0, 1.0);
    vec4 value = vec4(1.0);
#ifdef SURFACES
    if (texelFetch(t_covered, at, 0).r < 1.0)
#endif
    {
        texel_main();
        value = widened(COMPUTED);
    }
    imageStore(o_image, at, value);
}
)";

}  // namespace

std::string compute_source(const std::string& fragment, const std::string& name) {
    constexpr std::string_view kFirst = "layout(location = 0) ";
    constexpr std::string_view kOut = "out ";
    std::string text = fmt::format(kBeforeComputing, kWorkGroup.x, kWorkGroup.y);
    std::istringstream lines(fragment);
    bool has_output = false;
    for (std::string line; std::getline(lines, line);) {
        std::string_view rest = line;
        if (rest.starts_with(kFirst)) rest.remove_prefix(kFirst.size());
        if (rest.starts_with(kOut)) {
            rest = rest.substr(0, rest.find(';'));
            // Where a file is compiled in several ways, the preprocessor leaves one of its outputs.
            line = fmt::format("#define COMPUTED {}\n{};", rest.substr(rest.rfind(' ') + 1),
                               rest.substr(kOut.size()));
            has_output = true;
        }
        replace_all(line, "gl_FragCoord", "texel_place");
        replace_all(line, "void main()", "void texel_main()");
        text += line + '\n';
    }
    if (!has_output) throw base::failure("the shader {} has no output to compute", name);
    return text + kAfterFragment;
}

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

Program::Program(const std::string& name) : program_(ProgramName::make()), name_(name) {}

Program::Program(const std::string& vertex, const std::string& fragment,
                 const std::vector<std::string>& defines)
    : Program(fragment) {
    const Shader shaders[] = {
        compile(GL_VERTEX_SHADER, vertex, shader_source(vertex), defines),
        compile(GL_FRAGMENT_SHADER, fragment, shader_source(fragment), defines)};
    link(shaders);
}

Program Program::computing(const std::string& fragment, const std::vector<std::string>& defines) {
    Program program(fragment);
    const Shader shaders[] = {compile(GL_COMPUTE_SHADER, fragment,
                                      compute_source(shader_source(fragment), fragment), defines)};
    program.link(shaders);
    return program;
}

void Program::link(std::span<const Shader> shaders) {
    for (const Shader& shader : shaders) glAttachShader(program_.name(), shader.name());
    glLinkProgram(program_.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        char log[4096] = "";
        glGetProgramInfoLog(program_.name(), sizeof log, nullptr, log);
        throw base::failure("the shader {} does not link:\n{}", name_, log);
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
