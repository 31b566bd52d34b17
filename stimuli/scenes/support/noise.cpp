// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/support/noise.h"

#include <array>
#include <cmath>

namespace obscura::stimuli {
namespace {

/// The 32-bit finaliser of MurmurHash3 (Appleby, public domain).
std::uint32_t mix(std::uint32_t value) {
    value ^= value >> 16;
    value *= 0x85ebca6bU;
    value ^= value >> 13;
    value *= 0xc2b2ae35U;
    return value ^ (value >> 16);
}

/// The part of a lattice point's hash that all points of the same x share.
std::uint32_t hash_column(int x, std::uint32_t seed) {
    std::uint32_t h = (seed + 1U) * 0x9e3779b9U;
    h ^= static_cast<std::uint32_t>(x) * 0x8da6b343U;
    return (h ^ (h >> 15)) * 0x2c1b3c6dU;
}

std::uint32_t hash_point(std::uint32_t column, int y, int z) {
    return mix(column + static_cast<std::uint32_t>(y) * 0xd8163841U +
               static_cast<std::uint32_t>(z) * 0xcb1ab31fU);
}

float to_unit(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1.0p-24F; }

/// The lattice cell of a coordinate; std::floor is a library call on plain x86-64.
int cell_of(float value) {
    const int towards_zero = static_cast<int>(value);
    return towards_zero - (value < static_cast<float>(towards_zero) ? 1 : 0);
}

glm::ivec2 cell_of(glm::vec2 p) { return {cell_of(p.x), cell_of(p.y)}; }

glm::ivec3 cell_of(glm::vec3 p) { return {cell_of(p.x), cell_of(p.y), cell_of(p.z)}; }

int wrap(int value, int period) {
    if (period <= 0 || (value >= 0 && value < period)) return value;
    const int rest = value % period;
    return rest < 0 ? rest + period : rest;
}

glm::ivec2 wrap(glm::ivec2 cell, glm::ivec2 period) {
    return {wrap(cell.x, period.x), wrap(cell.y, period.y)};
}

float fade(float t) { return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F); }

float lerp(float a, float b, float t) { return a + (b - a) * t; }

/// One of 8 directions, times the offset.
float slope(std::uint32_t bits, float x, float y) {
    constexpr float kA = 0.92387953F;  // cos(pi / 8)
    constexpr float kB = 0.38268343F;  // sin(pi / 8)
    constexpr std::array<std::array<float, 2>, 8> kDirections{
        {{kA, kB}, {-kA, kB}, {kA, -kB}, {-kA, -kB}, {kB, kA}, {kB, -kA}, {-kB, kA}, {-kB, -kA}}};
    const auto& direction = kDirections[bits >> 29];
    return direction[0] * x + direction[1] * y;
}

/// One of the 12 edge directions of a cube, times the offset (Perlin 2002).
float slope(std::uint32_t bits, glm::vec3 offset) {
    const std::uint32_t h = bits & 15U;
    const float u = h < 8 ? offset.x : offset.y;
    const float v = h < 4 ? offset.y : (h == 12 || h == 14 ? offset.x : offset.z);
    return ((h & 1U) != 0 ? -u : u) + ((h & 2U) != 0 ? -v : v);
}

template <typename Point, typename Octave>
float sum_octaves(Point p, int octaves, float gain, Octave octave) {
    float sum = 0.0F;
    float heights = 0.0F;
    float height = 1.0F;
    for (int i = 0; i < octaves; ++i) {
        sum += height * octave(p, i);
        heights += height;
        height *= gain;
        p *= 2.0F;
    }
    return heights > 0.0F ? sum / heights : 0.0F;
}

std::uint32_t octave_seed(std::uint32_t seed, int octave) {
    return seed + static_cast<std::uint32_t>(octave) * 0x9e3779b9U;
}

}  // namespace

std::uint32_t hash_lattice(int x, int y, int z, std::uint32_t seed) {
    return hash_point(hash_column(x, seed), y, z);
}

float hash_unit(int x, int y, int z, std::uint32_t seed) {
    return to_unit(hash_lattice(x, y, z, seed));
}

float value_noise(glm::vec2 p, std::uint32_t seed, glm::ivec2 period) {
    const glm::ivec2 base = cell_of(p);
    const glm::vec2 f = p - glm::vec2(base);
    const glm::ivec2 low = wrap(base, period);
    const glm::ivec2 high = wrap(base + 1, period);
    const float u = fade(f.x);
    const float bottom =
        lerp(hash_unit(low.x, low.y, 0, seed), hash_unit(high.x, low.y, 0, seed), u);
    const float top =
        lerp(hash_unit(low.x, high.y, 0, seed), hash_unit(high.x, high.y, 0, seed), u);
    return lerp(bottom, top, fade(f.y));
}

float value_noise(glm::vec3 p, std::uint32_t seed) {
    const glm::ivec3 i = cell_of(p);
    const glm::vec3 f = p - glm::vec3(i);
    std::array<float, 2> layer{};
    for (int z = 0; z < 2; ++z) {
        const float bottom = lerp(hash_unit(i.x, i.y, i.z + z, seed),
                                  hash_unit(i.x + 1, i.y, i.z + z, seed), fade(f.x));
        const float top = lerp(hash_unit(i.x, i.y + 1, i.z + z, seed),
                               hash_unit(i.x + 1, i.y + 1, i.z + z, seed), fade(f.x));
        layer[static_cast<std::size_t>(z)] = lerp(bottom, top, fade(f.y));
    }
    return lerp(layer[0], layer[1], fade(f.z));
}

float gradient_noise(glm::vec2 p, std::uint32_t seed, glm::ivec2 period) {
    const glm::ivec2 base = cell_of(p);
    const glm::vec2 f = p - glm::vec2(base);
    const glm::ivec2 low = wrap(base, period);
    const glm::ivec2 high = wrap(base + 1, period);
    const std::uint32_t left = hash_column(low.x, seed);
    const std::uint32_t right = hash_column(high.x, seed);
    const float a = slope(hash_point(left, low.y, 0), f.x, f.y);
    const float b = slope(hash_point(right, low.y, 0), f.x - 1.0F, f.y);
    const float c = slope(hash_point(left, high.y, 0), f.x, f.y - 1.0F);
    const float d = slope(hash_point(right, high.y, 0), f.x - 1.0F, f.y - 1.0F);
    const float u = fade(f.x);
    // Unit gradients reach sqrt(1/2) at most; the factor brings them to about [-1, 1].
    return 1.4142136F * lerp(lerp(a, b, u), lerp(c, d, u), fade(f.y));
}

float gradient_noise(glm::vec3 p, std::uint32_t seed) {
    const glm::ivec3 i = cell_of(p);
    const glm::vec3 f = p - glm::vec3(i);
    std::array<float, 8> corner{};
    for (int k = 0; k < 8; ++k) {
        const glm::ivec3 step(k & 1, (k >> 1) & 1, k >> 2);
        corner[static_cast<std::size_t>(k)] = slope(
            hash_lattice(i.x + step.x, i.y + step.y, i.z + step.z, seed), f - glm::vec3(step));
    }
    const glm::vec3 t(fade(f.x), fade(f.y), fade(f.z));
    const float near_layer =
        lerp(lerp(corner[0], corner[1], t.x), lerp(corner[2], corner[3], t.x), t.y);
    const float far_layer =
        lerp(lerp(corner[4], corner[5], t.x), lerp(corner[6], corner[7], t.x), t.y);
    return lerp(near_layer, far_layer, t.z);
}

float fbm(glm::vec2 p, std::uint32_t seed, int octaves, glm::ivec2 period, float gain) {
    return sum_octaves(p, octaves, gain, [&](glm::vec2 q, int octave) {
        return gradient_noise(q, octave_seed(seed, octave), period * (1 << octave));
    });
}

float fbm(glm::vec3 p, std::uint32_t seed, int octaves, float gain) {
    return sum_octaves(p, octaves, gain, [&](glm::vec3 q, int octave) {
        return gradient_noise(q, octave_seed(seed, octave));
    });
}

float ridged(glm::vec2 p, std::uint32_t seed, int octaves, glm::ivec2 period, float gain) {
    return sum_octaves(p, octaves, gain, [&](glm::vec2 q, int octave) {
        return 1.0F -
               std::abs(gradient_noise(q, octave_seed(seed, octave), period * (1 << octave)));
    });
}

float ridged(glm::vec3 p, std::uint32_t seed, int octaves, float gain) {
    return sum_octaves(p, octaves, gain, [&](glm::vec3 q, int octave) {
        return 1.0F - std::abs(gradient_noise(q, octave_seed(seed, octave)));
    });
}

NoiseTile::NoiseTile(std::uint32_t seed, int cells, int octaves)
    : values_(static_cast<std::size_t>(kSize) * kSize) {
    const float step = static_cast<float>(cells) / kSize;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const glm::vec2 p(static_cast<float>(x) * step, static_cast<float>(y) * step);
            values_[static_cast<std::size_t>(y * kSize + x)] =
                fbm(p, seed, octaves, {cells, cells});
        }
    }
}

float NoiseTile::at(glm::vec2 uv) const {
    const glm::vec2 p = uv * static_cast<float>(kSize);
    const glm::ivec2 base = cell_of(p);
    const glm::vec2 f = p - glm::vec2(base);
    constexpr int kMask = kSize - 1;
    const auto value = [&](int x, int y) {
        return values_[static_cast<std::size_t>((y & kMask) * kSize + (x & kMask))];
    };
    return lerp(lerp(value(base.x, base.y), value(base.x + 1, base.y), f.x),
                lerp(value(base.x, base.y + 1), value(base.x + 1, base.y + 1), f.x), f.y);
}

CellularNoise cellular(glm::vec2 p, std::uint32_t seed, glm::ivec2 period) {
    const glm::ivec2 base = cell_of(p);
    CellularNoise found{1e9F, 1e9F, 0, {}};
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            const glm::ivec2 cell = base + glm::ivec2(x, y);
            const glm::ivec2 wrapped = wrap(cell, period);
            const std::uint32_t id = hash_lattice(wrapped.x, wrapped.y, 0, seed);
            const glm::vec2 point = glm::vec2(cell) + glm::vec2(to_unit(id), to_unit(mix(id)));
            const float distance = glm::dot(point - p, point - p);
            if (distance < found.nearest) {
                found = {distance, found.nearest, id, point - p};
            } else if (distance < found.second) {
                found.second = distance;
            }
        }
    }
    found.nearest = std::sqrt(found.nearest);
    found.second = std::sqrt(found.second);
    return found;
}

CellularNoise cellular(glm::vec3 p, std::uint32_t seed) {
    const glm::ivec3 base = cell_of(p);
    CellularNoise found{1e9F, 1e9F, 0, {}};
    for (int k = 0; k < 27; ++k) {
        const glm::ivec3 cell = base + glm::ivec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        const std::uint32_t id = hash_lattice(cell.x, cell.y, cell.z, seed);
        const glm::vec3 point =
            glm::vec3(cell) + glm::vec3(to_unit(id), to_unit(mix(id)), to_unit(mix(id + 1)));
        const float distance = glm::dot(point - p, point - p);
        if (distance < found.nearest) {
            found = {distance, found.nearest, id, glm::vec2(point - p)};
        } else if (distance < found.second) {
            found.second = distance;
        }
    }
    found.nearest = std::sqrt(found.nearest);
    found.second = std::sqrt(found.second);
    return found;
}

}  // namespace obscura::stimuli
