// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace obscura::renderer {
namespace {

/// Enough for a standard error that can be trusted, few enough that it is not far too high.
constexpr int kMostParts = 8;

int parts_for(int rays) {
    if (rays < 8) return std::min(rays, 2);
    return std::min(kMostParts, rays / 4);
}

constexpr std::uint32_t reversed_bits(std::uint32_t v) {
    v = (v >> 16) | (v << 16);
    v = ((v & 0x00ff00ffU) << 8) | ((v & 0xff00ff00U) >> 8);
    v = ((v & 0x0f0f0f0fU) << 4) | ((v & 0xf0f0f0f0U) >> 4);
    v = ((v & 0x33333333U) << 2) | ((v & 0xccccccccU) >> 2);
    return ((v & 0x55555555U) << 1) | ((v & 0xaaaaaaaaU) >> 1);
}

constexpr std::uint32_t owen_hash(std::uint32_t reversed, std::uint32_t seed) {
    std::uint32_t v = reversed + seed;
    v ^= v * 0x6c50b47cU;
    v ^= v * 0xb82f1e52U;
    v ^= v * 0xc7afe638U;
    v ^= v * 0x8d22f6e6U;
    return reversed_bits(v);
}

/// The middle of one of 2^24 equal parts of [-1, 1]: exact in a float.
constexpr float signed_unit(std::uint32_t bits) {
    return static_cast<float>(static_cast<std::int32_t>(bits >> 8) - (1 << 23)) * 0x1.0p-23F +
           0x1.0p-24F;
}

/// Second dimension of the Sobol sequence (Joe and Kuo 2008, table new-joe-kuo-6: primitive
/// polynomial x + 1, m = 1, hence each direction number is the last one xor its half).
std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t value = 0;
    for (std::uint32_t direction = 0x80000000U; index != 0; index >>= 1) {
        if ((index & 1U) != 0) value ^= direction;
        direction ^= direction >> 1;
    }
    return value;
}

/// What fill() reads and writes.
struct Points {
    const std::uint32_t* first;
    const std::uint32_t* second;
    int count;
    std::uint32_t first_seed;
    std::uint32_t second_seed;
    float* x;
    float* y;
    float* z;
};

/// Free of branches, so that compilers do several at a time.
[[gnu::always_inline]] inline void fill(const Points& points, const glm::mat3& frame) {
    constexpr float kQuarterPi = std::numbers::pi_v<float> / 4.0F;
    const auto [first, second, count, first_seed, second_seed, out_x, out_y, out_z] = points;
    const glm::mat3 m = frame;
    for (int i = 0; i < count; ++i) {
        const float a = signed_unit(owen_hash(first[i], first_seed));
        const float b = signed_unit(owen_hash(second[i], second_seed));
        const bool wide = std::abs(a) > std::abs(b);
        const float r = wide ? a : b;  // never 0: signed_unit is half a step off
        const float phi = kQuarterPi * ((wide ? b : a) / r);
        // Taylor polynomials; below 3e-8 over |phi| <= pi/4.
        const float q = phi * phi;
        const float sine =
            phi * (1.0F + q * (-1.0F / 6 + q * (1.0F / 120 + q * (-1.0F / 5040 + q / 362880))));
        const float cosine =
            1.0F + q * (-0.5F + q * (1.0F / 24 + q * (-1.0F / 720 + q * (1.0F / 40320))));
        const float x = r * (wide ? cosine : sine);
        const float y = r * (wide ? sine : cosine);
        const float z = std::sqrt((1.0F - r) * (1.0F + r));
        out_x[i] = m[0].x * x + m[1].x * y + m[2].x * z;
        out_y[i] = m[0].y * x + m[1].y * y + m[2].y * z;
        out_z[i] = m[0].z * x + m[1].z * y + m[2].z * z;
    }
}

// The same operations in the same order, so the same bits: eight at a time where the processor can.
[[gnu::target("avx2")]] void fill_wide(const Points& points, const glm::mat3& frame) {
    fill(points, frame);
}
void fill_narrow(const Points& points, const glm::mat3& frame) { fill(points, frame); }

/// The leading 16 bits of two binary fractions, interleaved.
std::uint32_t interleaved(std::uint32_t a, std::uint32_t b) {
    std::uint32_t code = 0;
    for (int bit = 31; bit >= 16; --bit) code = code << 2 | (a >> bit & 1U) << 1 | (b >> bit & 1U);
    return code;
}

}  // namespace

std::uint32_t owen_scrambled(std::uint32_t reversed, std::uint32_t seed) {
    return owen_hash(reversed, seed);
}

HemisphereSampler::HemisphereSampler(int rays) : rays_(rays) {
    const int parts = parts_for(rays);
    const int longer = rays % parts;  // the first so many parts have a ray more
    for (int part = 0; part < parts; ++part) lengths_.push_back(rays / parts + (part < longer));
    struct Point {
        std::uint32_t first;
        std::uint32_t second;
        std::uint8_t part;
        std::uint32_t place;
    };
    std::vector<Point> points;
    std::uint32_t index = 0;
    for (int part = 0; part < parts; ++part) {
        for (int i = 0; i < lengths_[static_cast<std::size_t>(part)]; ++i, ++index) {
            const std::uint32_t second = sobol_second(index);
            points.push_back({index, reversed_bits(second), static_cast<std::uint8_t>(part),
                              interleaved(reversed_bits(index), second)});
        }
    }
    std::sort(points.begin(), points.end(),
              [](const Point& a, const Point& b) { return a.place < b.place; });
    for (const Point& point : points) {
        first_.push_back(point.first);
        second_.push_back(point.second);
        part_.push_back(point.part);
    }
}

namespace {

void fill_as_wide_as_can_be(const Points& points, const glm::mat3& frame) {
    static const bool wide = __builtin_cpu_supports("avx2") != 0;
    if (wide) {
        fill_wide(points, frame);
    } else {
        fill_narrow(points, frame);
    }
}

}  // namespace

void HemisphereSampler::directions(std::uint64_t scramble, const glm::mat3& frame, float* x,
                                   float* y, float* z) const {
    const std::uint64_t seeds = mixed_bits(scramble);
    fill_as_wide_as_can_be({first_.data(), second_.data(), rays_, static_cast<std::uint32_t>(seeds),
                            static_cast<std::uint32_t>(seeds >> 32), x, y, z},
                           frame);
}

BlockSampler::BlockSampler(int rays) {
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(kSide * kSide * rays); ++i) {
        first_.push_back(i);
        second_.push_back(reversed_bits(sobol_second(i)));
    }
}

int BlockSampler::part_of(int x, int y) {
    return (x & 1) | (y & 1) << 1 | (x & 2) << 1 | (y & 2) << 2;
}

void BlockSampler::directions(std::uint64_t scramble, float* x, float* y, float* z) const {
    const std::uint64_t seeds = mixed_bits(scramble);
    fill_as_wide_as_can_be(
        {first_.data(), second_.data(), static_cast<int>(first_.size()),
         static_cast<std::uint32_t>(seeds), static_cast<std::uint32_t>(seeds >> 32), x, y, z},
        glm::mat3(1.0F));
}

}  // namespace obscura::renderer
