// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "renderer/base/random.h"

namespace obscura::renderer {
namespace {

struct Directions {
    explicit Directions(int rays, std::uint64_t scramble = 5)
        : x(static_cast<std::size_t>(rays)), y(x), z(x) {
        HemisphereSampler(rays).directions(scramble, glm::mat3(1.0F), x.data(), y.data(), z.data());
    }
    std::vector<float> x, y, z;
};

/// Back to the unit square: the inverse of the concentric map.
std::pair<double, double> square_of(double x, double y) {
    const double r = std::hypot(x, y);
    double phi = std::atan2(y, x);
    if (phi < -std::numbers::pi / 4.0) phi += 2.0 * std::numbers::pi;
    const double quarter = std::numbers::pi / 4.0;
    double a = 0.0;
    double b = 0.0;
    if (phi < quarter) {
        a = r;
        b = phi * a / quarter;
    } else if (phi < 3.0 * quarter) {
        b = r;
        a = -(phi - 2.0 * quarter) * b / quarter;
    } else if (phi < 5.0 * quarter) {
        a = -r;
        b = (phi - 4.0 * quarter) * a / quarter;
    } else {
        b = -r;
        a = -(phi - 6.0 * quarter) * b / quarter;
    }
    return {0.5 * (a + 1.0), 0.5 * (b + 1.0)};
}

TEST(HemisphereSampler, GivesUnitVectorsOfTheUpperHemisphere) {
    const Directions d(4096);
    for (std::size_t i = 0; i < d.z.size(); ++i) {
        ASSERT_NEAR(d.x[i] * d.x[i] + d.y[i] * d.y[i] + d.z[i] * d.z[i], 1.0F, 1e-6F);
        ASSERT_GT(d.z[i], 0.0F);
    }
}

TEST(HemisphereSampler, HasTheMomentsOfTheCosineDensity) {
    const Directions d(65536);
    double z = 0.0;
    double zz = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (std::size_t i = 0; i < d.z.size(); ++i) {
        z += d.z[i] / 65536.0;
        zz += d.z[i] * d.z[i] / 65536.0;
        x += d.x[i] / 65536.0;
        y += d.y[i] / 65536.0;
    }
    EXPECT_NEAR(z, 2.0 / 3.0, 1e-4);
    EXPECT_NEAR(zz, 0.5, 1e-4);
    EXPECT_NEAR(x, 0.0, 1e-4);
    EXPECT_NEAR(y, 0.0, 1e-4);
}

// The defining property of a (0, m, 2)-net in base 2, which Owen's scrambling keeps: every
// elementary interval of area 1/256 holds one of 256 points.
TEST(HemisphereSampler, KeepsOnePointInEveryElementaryInterval) {
    for (const std::uint64_t scramble : {0ULL, 1ULL, 77ULL}) {
        const Directions d(256, scramble);
        for (int split = 0; split <= 8; ++split) {
            const int columns = 1 << split;
            const int rows = 256 / columns;
            std::set<std::pair<int, int>> cells;
            for (std::size_t i = 0; i < d.z.size(); ++i) {
                const auto [u, v] = square_of(d.x[i], d.y[i]);
                cells.emplace(static_cast<int>(u * columns), static_cast<int>(v * rows));
            }
            // The inverse map is rounded: a point on a border may fall on its other side.
            EXPECT_GE(cells.size(), 255U) << columns << " columns, scramble " << scramble;
        }
    }
}

TEST(HemisphereSampler, ListsNeighboursTogether) {
    const Directions d(256);
    // Sixteen in a row lie in one of sixteen cells of the square.
    for (std::size_t first = 0; first < 256; first += 16) {
        std::set<std::pair<int, int>> cells;
        for (std::size_t i = first; i < first + 16; ++i) {
            const auto [u, v] = square_of(d.x[i], d.y[i]);
            cells.emplace(static_cast<int>(u * 4.0), static_cast<int>(v * 4.0));
        }
        EXPECT_EQ(cells.size(), 1U);
    }
}

TEST(HemisphereSampler, SplitsAnyNumberOfRaysIntoPartsOfNearlyTheSameLength) {
    for (const int rays : {1, 2, 3, 7, 8, 15, 16, 31, 32, 33, 100, 65536}) {
        const HemisphereSampler sampler(rays);
        std::vector<int> counted(static_cast<std::size_t>(sampler.parts()));
        for (const std::uint8_t part : sampler.part_of_ray()) ++counted.at(part);
        int sum = 0;
        for (int part = 0; part < sampler.parts(); ++part) {
            const int length = sampler.length_of(part);
            EXPECT_EQ(counted[static_cast<std::size_t>(part)], length);
            EXPECT_GE(length, rays / sampler.parts());
            EXPECT_LE(length, rays / sampler.parts() + 1);
            sum += length;
        }
        EXPECT_EQ(sum, rays);
        EXPECT_EQ(sampler.parts() >= 2, rays >= 2);
    }
}

TEST(OwenScramble, KeepsEqualLeadingBitsEqualAndSeparatesTheNext) {
    base::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const auto seed = static_cast<std::uint32_t>(random.bits());
        const auto reversed = static_cast<std::uint32_t>(random.bits());
        const auto shared = static_cast<int>(random.below(32));
        // Reversed bits: the leading ones are the low ones.
        const std::uint32_t other = reversed ^ (1U << shared);
        const std::uint32_t apart = owen_scrambled(reversed, seed) ^ owen_scrambled(other, seed);
        ASSERT_EQ(apart >> (31 - shared), 1U) << "bit " << shared;
    }
}

TEST(OwenScramble, FlipsEveryBitHalfOfTheTimeOverSeeds) {
    base::Random random(9);
    int ones[32] = {};
    constexpr int kSeeds = 4000;
    for (int i = 0; i < kSeeds; ++i) {
        const std::uint32_t value = owen_scrambled(0, static_cast<std::uint32_t>(random.bits()));
        for (int bit = 0; bit < 32; ++bit) ones[bit] += static_cast<int>(value >> bit & 1U);
    }
    // Five standard deviations of a fair coin.
    for (int bit = 0; bit < 32; ++bit) EXPECT_NEAR(ones[bit], kSeeds / 2, 160) << "bit " << bit;
}

}  // namespace
}  // namespace obscura::renderer
