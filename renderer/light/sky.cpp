// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <thread>

#include "renderer/base/check.h"
#include "renderer/light/environment.h"

namespace obscura::renderer {
namespace {

/// A value in [0, 1) for a lattice point, by integer hashing (Jarzynski and Olano 2020, pcg3d's
/// multiply-xor pattern reduced to one output).
float lattice(int x, int y, std::uint32_t seed) {
    std::uint32_t h = seed * 747796405U + 2891336453U;
    h ^= static_cast<std::uint32_t>(x) * 0x8da6b343U;
    h ^= static_cast<std::uint32_t>(y) * 0xd8163841U;
    h = (h ^ (h >> 15)) * 0x2c1b3c6dU;
    h = (h ^ (h >> 12)) * 0x297a2d39U;
    h ^= h >> 15;
    return static_cast<float>(h >> 8) * 0x1.0p-24F;
}

float smooth_noise(glm::vec2 p, std::uint32_t seed) {
    const glm::vec2 cell = glm::floor(p);
    const glm::vec2 f = p - cell;
    const glm::vec2 s = f * f * (3.0F - 2.0F * f);
    const int x = static_cast<int>(cell.x);
    const int y = static_cast<int>(cell.y);
    return glm::mix(glm::mix(lattice(x, y, seed), lattice(x + 1, y, seed), s.x),
                    glm::mix(lattice(x, y + 1, seed), lattice(x + 1, y + 1, seed), s.x), s.y);
}

/// Sum of octaves, in [0, 1).
float clouds(glm::vec2 p, std::uint32_t seed) {
    float sum = 0.0F;
    float amplitude = 0.5F;
    for (std::uint32_t octave = 0; octave < 6; ++octave) {
        sum += amplitude * smooth_noise(p, seed + octave);
        p = glm::mat2(0.8F, 0.6F, -0.6F, 0.8F) * p * 2.02F;
        amplitude *= 0.5F;
    }
    return sum / 0.984375F;
}

glm::vec3 sky_radiance(const SkyColours& sky, const glm::vec3& sun, const glm::vec3& direction) {
    if (direction.y < 0.0F) {
        const float haze = std::exp(12.0F * direction.y);
        return glm::mix(sky.ground, sky.horizon, 0.6F * haze);
    }
    const float height = std::pow(direction.y, 0.55F);
    glm::vec3 colour = glm::mix(sky.horizon, sky.zenith, height);
    const float along = std::max(glm::dot(direction, sun), 0.0F);
    colour += sky.sun_glow * (0.35F * std::pow(along, 6.0F) + 1.5F * std::pow(along, 180.0F));
    if (sky.cloud_cover > 0.0F) {
        // A flat layer of clouds, seen in perspective, that thins out towards the horizon.
        const glm::vec2 layer = glm::vec2(direction.x, direction.z) / (direction.y + 0.12F);
        const auto seed = static_cast<std::uint32_t>(sky.seed * 101U);
        const float density = clouds(layer * 1.7F, seed);
        const float lit = clouds(layer * 1.7F + 0.12F * glm::vec2(sun.x, sun.z), seed);
        const float threshold = 0.78F - 0.5F * sky.cloud_cover;
        const float cover = glm::smoothstep(threshold, threshold + 0.22F, density) *
                            glm::smoothstep(0.02F, 0.2F, direction.y);
        const float shade = std::clamp(0.85F + 1.2F * (density - lit), 0.6F, 1.15F);
        const glm::vec3 white = (sky.horizon + glm::vec3(glm::length(sky.horizon))) * 0.5F;
        colour = glm::mix(colour, white * shade, 0.9F * cover);
    }
    return colour;
}

}  // namespace

Environment make_sky(const SkyColours& colours, int width) {
    base::check_range("make_sky", "width", width, 4, 16384);
    Environment sky;
    sky.name = "procedural sky";
    sky.width = width;
    sky.height = width / 2;
    sky.radiance.resize(static_cast<std::size_t>(sky.width) * sky.height);
    const glm::vec3 sun = glm::normalize(colours.towards_sun);
    const auto fill = [&](int first, int step) {
        for (int row = first; row < sky.height; row += step) {
            for (int column = 0; column < sky.width; ++column) {
                sky.radiance[static_cast<std::size_t>(row) * sky.width + column] =
                    sky_radiance(colours, sun, direction_of_texel(sky, column, row));
            }
        }
    };
    const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::jthread> workers;
    for (int i = 1; i < threads; ++i) workers.emplace_back(fill, i, threads);
    fill(0, threads);
    return sky;
}

}  // namespace obscura::renderer
