// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/garden/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::garden {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

/// Colour of a brick: fired unevenly, some nearly black.
vec3 brick_colour(std::uint32_t seed) {
    const int i = static_cast<int>(seed);
    const float fired = hash_unit(i, 0, 0, 51);
    vec3 colour =
        glm::mix(vec3(0.30F, 0.125F, 0.080F), vec3(0.42F, 0.22F, 0.145F), hash_unit(i, 1, 0, 51));
    if (fired > 0.88F) colour = vec3(0.13F, 0.085F, 0.075F);
    if (fired < 0.10F) colour = vec3(0.46F, 0.31F, 0.20F);
    return colour;
}

/// A wall of single bricks in the plane z = 0 from x = 0 to `length`, with piers and coping.
void put_wall(Assembly& garden, const glm::mat4& place, float length, std::uint32_t seed) {
    constexpr float kCourse = 0.075F;
    constexpr float kStep = 0.225F;
    constexpr float kFoot = 0.1F;  // below the ground, which is nowhere even
    constexpr float kLap = 0.05F;  // into the wall that meets it, so that no sky shows between
    const int courses = static_cast<int>(kWallHigh / kCourse);
    const int along = static_cast<int>(length / kStep) + 1;
    garden.put(Surface::kMortar,
               rectangle({-kLap, -kFoot, -0.007F}, {length + 2.0F * kLap, 0.0F, 0.0F},
                         {0.0F, kWallHigh + kFoot, 0.0F}, 0.5F),
               place, seed);
    const Mesh brick = bevelled_box({0.214F, 0.064F, 0.10F}, 0.005F);
    for (int row = 0; row < courses; ++row) {
        for (int i = 0; i <= along; ++i) {
            const std::uint32_t own = hash_lattice(i, row, 0, seed);
            const int k = static_cast<int>(own & 0xffffU);
            const float x = kStep * (static_cast<float>(i) + (row % 2 == 0 ? 0.0F : 0.5F));
            if (x > length) continue;
            if (hash_unit(k, 2, 0, 3) > 0.975F) continue;  // fallen out, the hole filled
            const float out = 0.006F * (hash_unit(k, 1, 0, 3) - 0.5F);
            const float turn = 0.02F * (hash_unit(k, 3, 0, 3) - 0.5F);
            // Damp darkens and greens the foot of the wall.
            const float y = kCourse * (static_cast<float>(row) + 0.5F);
            const float damp = std::exp(-y / 0.35F);
            const vec3 tint =
                brick_colour(own) * glm::mix(vec3(1.0F), vec3(0.62F, 0.74F, 0.52F), damp);
            garden.put(Surface::kBrick, brick,
                       place * moved(x, y, -0.05F + out) * about_z(turn) * about_y(0.5F * turn),
                       own, tint);
        }
    }
    // Coping of stone slabs.
    const int slabs = static_cast<int>(length / 0.62F) + 1;
    for (int i = 0; i < slabs; ++i) {
        const auto own = seed + static_cast<std::uint32_t>(i);
        const float nudge = 0.008F * (hash_unit(i, 5, 0, seed) - 0.5F);
        garden.put(Surface::kStone, bevelled_box({0.614F, 0.07F, 0.40F}, 0.016F),
                   place *
                       moved(0.62F * (static_cast<float>(i) + 0.5F),
                             kWallHigh + 0.035F + 0.3F * nudge, -0.12F + nudge) *
                       about_y(nudge),
                   own, shade_of(own, 0.25F));
    }
    // The wall's back, so that no light comes through.
    garden.put(Surface::kMortar,
               rectangle({length + kLap, 0.0F, -0.24F}, {-length - 2.0F * kLap, 0.0F, 0.0F},
                         {0.0F, kWallHigh, 0.0F}, 1.0F),
               place, seed);
}

void put_pier(Assembly& garden, const glm::mat4& place, std::uint32_t seed) {
    const Mesh brick = bevelled_box({0.214F, 0.064F, 0.10F}, 0.005F);
    for (int row = 0; row < 32; ++row) {
        const float y = 0.075F * (static_cast<float>(row) + 0.5F);
        // Bonded: two stretchers in front and one on each side behind them; in the next course one
        // in front, between the ends of those on the sides.
        const bool two = row % 2 == 0;
        for (int i = 0; i < (two ? 4 : 3); ++i) {
            const std::uint32_t own = hash_lattice(i, row, 7, seed);
            const float side = i % 2 == 0 ? -1.0F : 1.0F;
            const bool front = two ? i >= 2 : i == 2;
            const glm::mat4 spot = front ? moved(two ? side * 0.1125F : 0.0F, y, 0.12F)
                                         : moved(side * 0.1725F, y, two ? -0.045F : 0.063F) *
                                               about_y(glm::half_pi<float>());
            garden.put(Surface::kBrick, brick, place * spot, own, brick_colour(own));
        }
    }
    garden.put(Surface::kMortar, bevelled_box({0.43F, 2.40F, 0.32F}, 0.0F),
               place * moved(0.0F, 1.20F, 0.001F), seed);
    garden.put(Surface::kStone, bevelled_box({0.56F, 0.09F, 0.56F}, 0.02F),
               place * moved(0.0F, 2.45F, -0.05F), seed);
    std::vector<vec2> ball;
    for (int i = 0; i <= 16; ++i) {
        const float a = glm::pi<float>() * (static_cast<float>(i) / 16.0F - 0.5F);
        ball.emplace_back(i == 0 || i == 16 ? 0.0F : 0.17F * std::cos(a), 0.17F * std::sin(a));
    }
    const std::array<vec2, 5> foot{
        {{0.0F, 0.0F}, {0.13F, 0.0F}, {0.12F, 0.03F}, {0.08F, 0.06F}, {0.0F, 0.08F}}};
    garden.put(Surface::kStone, revolve(foot, 32), place * moved(0.0F, 2.495F, -0.05F), seed);
    garden.put(Surface::kStone, revolve(ball, 36), place * moved(0.0F, 2.70F, -0.05F), seed);
}

}  // namespace

void build_walls(Assembly& garden) {
    put_wall(garden, moved(kSideX, 0.0F, kWallZ), kRight - kSideX, 1000U);
    put_wall(garden, moved(kSideX, 0.0F, kFront) * about_y(glm::half_pi<float>()), kFront - kWallZ,
             2000U);
    put_pier(garden, moved(kPierX[0], 0.0F, kWallZ), 3000U);
    put_pier(garden, moved(kPierX[1], 0.0F, kWallZ), 3100U);
}

}  // namespace obscura::stimuli::garden
