// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace obscura::renderer {
namespace {

/// Enough parts for a standard error that can be trusted, few enough that each keeps the quick
/// convergence of its sequence: at least four rays each.
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

/// One part's directions. Free of branches, so that compilers do several at a time.
void fill(const std::uint32_t* sobol, int count, std::uint32_t seed_a, std::uint32_t seed_b,
          float* x, float* y, float* z) {
    constexpr float kQuarterPi = std::numbers::pi_v<float> / 4.0F;
    for (int i = 0; i < count; ++i) {
        const float a = signed_unit(owen_hash(static_cast<std::uint32_t>(i), seed_a));
        const float b = signed_unit(owen_hash(sobol[i], seed_b));
        const bool wide = std::abs(a) > std::abs(b);
        const float r = wide ? a : b;  // never 0: signed_unit is half a step off
        const float phi = kQuarterPi * ((wide ? b : a) / r);
        // Taylor polynomials; below 3e-8 over |phi| <= pi/4.
        const float q = phi * phi;
        const float sine =
            phi * (1.0F + q * (-1.0F / 6 + q * (1.0F / 120 + q * (-1.0F / 5040 + q / 362880))));
        const float cosine =
            1.0F + q * (-0.5F + q * (1.0F / 24 + q * (-1.0F / 720 + q * (1.0F / 40320))));
        x[i] = r * (wide ? cosine : sine);
        y[i] = r * (wide ? sine : cosine);
        z[i] = std::sqrt((1.0F - r) * (1.0F + r));
    }
}

}  // namespace

std::uint32_t owen_scrambled(std::uint32_t reversed, std::uint32_t seed) {
    return owen_hash(reversed, seed);
}

HemisphereSampler::HemisphereSampler(int rays) : rays_(rays) {
    const int parts = parts_for(rays);
    const int each = rays / parts;
    const int longer = rays % parts;  // the first so many parts have a ray more
    for (int part = 0; part <= parts; ++part) {
        first_.push_back(part * each + std::min(part, longer));
    }
    for (std::uint32_t i = 0; i <= static_cast<std::uint32_t>(each); ++i) {
        sobol_.push_back(reversed_bits(sobol_second(i)));
    }
}

void HemisphereSampler::directions(std::uint64_t scramble, float* x, float* y, float* z) const {
    for (int part = 0; part < parts(); ++part) {
        const std::uint64_t seeds = mixed_bits(scramble + static_cast<std::uint64_t>(part));
        const int first = first_of(part);
        fill(sobol_.data(), first_of(part + 1) - first, static_cast<std::uint32_t>(seeds),
             static_cast<std::uint32_t>(seeds >> 32), x + first, y + first, z + first);
    }
}

}  // namespace obscura::renderer
