// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "renderer/gl/program.h"
#include "renderer/hard_cases/bench.h"

namespace obscura::renderer {
namespace {

/// The axes, their near-negatives to the last bit, then random directions.
std::vector<glm::vec3> hard_vectors(int count) {
    std::vector<glm::vec3> vectors;
    for (const float sign : {1.0F, -1.0F}) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 v(0.0F);
            v[axis] = sign;
            vectors.push_back(v);
            for (float off = 1e-9F; off < 0.1F; off *= 3.0F) {
                v[(axis + 1) % 3] = off;
                v[(axis + 2) % 3] = -0.5F * off;
                vectors.push_back(glm::normalize(v));
            }
        }
    }
    base::Random random(7);
    while (vectors.size() < static_cast<std::size_t>(count)) {
        const double z = random.uniform(-1.0, 1.0);
        const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double s = std::sqrt(1.0 - z * z);
        vectors.emplace_back(s * std::cos(phi), s * std::sin(phi), z);
    }
    return vectors;
}

/// The largest value of each channel of what the probe draws over a list of vectors.
std::array<float, 4> largest_deviations(std::vector<glm::vec3> vectors) {
    constexpr int kWidth = 1000;
    const int height = static_cast<int>((vectors.size() + kWidth - 1) / kWidth);
    vectors.resize(static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(height),
                   {0.0F, 0.0F, 1.0F});
    const gl::Texture input = gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
    glTextureStorage2D(input.name(), 1, GL_RGB32F, kWidth, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(input.name(), 0, 0, 0, kWidth, height, GL_RGB, GL_FLOAT, vectors.data());
    glTextureParameteri(input.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(input.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const gl::Texture output = gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
    glTextureStorage2D(output.name(), 1, GL_RGBA32F, kWidth, height);
    const gl::Framebuffer framebuffer = gl::Framebuffer::make();
    glNamedFramebufferTexture(framebuffer.name(), GL_COLOR_ATTACHMENT0, output.name(), 0);
    const gl::VertexArray nothing = gl::VertexArray::make();
    gl::Program probe("passes/full_screen.vert.glsl", "hard_cases/rotation_probe.glsl", {});
    glBindTextureUnit(0, input.name());
    probe.set("t_vectors", 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glViewport(0, 0, kWidth, height);
    for (const GLenum test : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) {
        glDisable(test);
    }
    probe.use();
    glBindVertexArray(nothing.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    std::vector<float> values(4 * vectors.size());
    glGetTextureImage(output.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(values.size() * sizeof(float)), values.data());
    std::array<float, 4> largest{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        largest[i % 4] = std::max(largest[i % 4], values[i]);
    }
    return largest;
}

/// Case 7. The shaders' own rotation, on the GPU, over random vectors, the axes and their
/// near-negatives.
void run_rotations(Bench& bench) {
    const std::array<float, 4> largest = largest_deviations(hard_vectors(bench.options().vectors));
    const char* const quantities[4] = {
        "rotation: largest element of transpose(M) M - 1", "rotation: determinant - 1",
        "rotation: distance of the turned +Z from r", "reflection: change of length"};
    for (std::size_t i = 0; i < 4; ++i) {
        bench.expect(quantities[i], 0.0, static_cast<double>(largest[i]), 1e-5);
    }
}

}  // namespace

HardCase rotations_case() { return {7, "rotations and frames", nullptr, run_rotations}; }

}  // namespace obscura::renderer
