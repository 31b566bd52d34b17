// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <span>

#include "stimuli/scenes/garden/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::garden {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

/// How much of the wall the ivy covers there, below 0 none.
float ivy_cover(float x, float y, std::uint32_t seed) {
    return 0.12F + 0.9F * fbm(vec2(0.55F * x, 0.8F * y), seed, 4) + 0.16F * (y - 1.0F);
}

/// Ivy on a wall in the plane z = 0: stems that climb from the ground, leaves thick where it
/// covers the wall, each hanging by its stalk with its face turned outwards. None where a pier
/// stands before the wall, at `piers`: it would stick out of the bricks.
void put_ivy(Assembly& garden, const glm::mat4& place, float length, int leaves, std::uint32_t seed,
             std::span<const float> piers) {
    const auto meets_pier = [piers](float x, float room) {
        return std::any_of(piers.begin(), piers.end(),
                           [x, room](float pier) { return std::abs(x - pier) < kPierHalf + room; });
    };
    constexpr float kStem = 0.012F;
    constexpr float kLeaf = 0.06F;
    base::Random random(seed);
    for (int i = 0; i < 60; ++i) {
        const float x = draw(random, 0.1F, length - 0.1F);
        std::vector<vec3> stem;
        vec2 at(x, 0.04F);
        for (int k = 0; k < 26; ++k) {
            if (meets_pier(at.x, kStem)) break;
            if (k > 3 && ivy_cover(at.x, at.y, seed) < -0.12F) break;
            stem.emplace_back(at.x, at.y, 0.008F);
            at += vec2(
                0.09F * gradient_noise(vec2(at.y * 3.0F, static_cast<float>(i) * 7.3F), seed + 1U),
                0.085F);
            if (at.y > kWallHigh) break;
        }
        if (stem.size() < 4) continue;
        garden.put(
            Surface::kWood,
            sweep(circle(draw(random, 0.004F, 0.010F), 6), frames_along(stem, {0.0F, 0.0F, 1.0F})),
            place, seed + static_cast<std::uint32_t>(i), vec3(0.6F, 0.55F, 0.45F));
    }
    const std::array<Mesh, 3> shapes{card(1.0F, 1.0F, 0.5F, 0.25F, 2),
                                     card(1.0F, 1.0F, 0.9F, 0.15F, 2),
                                     card(1.0F, 0.9F, 0.25F, 0.4F, 2)};
    int put = 0;
    for (int i = 0; i < 6 * leaves && put < leaves; ++i) {
        const float x = draw(random, 0.0F, length);
        const float y = draw(random, 0.05F, kWallHigh + 0.16F);
        const float cover = ivy_cover(x, y, seed);
        if (cover < 0.0F || meets_pier(x, kLeaf)) continue;
        ++put;
        const float deep = std::min(0.16F, 0.03F + 0.25F * cover);
        const float far_out = draw(random, 0.15F, 1.0F);
        const float size = draw(random, 0.05F, 0.105F) * (0.8F + 0.5F * std::min(cover, 0.4F));
        // Tips hang down and out; the back of the card faces the wall.
        const glm::mat4 turn = about_y(draw(random, -0.75F, 0.75F)) *
                               about_x(glm::pi<float>() - draw(random, 0.15F, 0.95F)) *
                               about_y(glm::pi<float>()) * about_z(draw(random, -0.7F, 0.7F));
        const auto own = static_cast<std::uint32_t>(random.below(1U << 20U));
        const bool young = random.below(9) == 0;
        const vec3 tint = shade_of(own, 0.4F) * glm::mix(0.62F, 1.0F, far_out) *
                          (young ? vec3(1.0F, 1.0F, 0.75F) : vec3(0.92F, 1.0F, 0.95F));
        const float top = y > kWallHigh ? 0.10F : 0.0F;
        garden.put_mapped(Surface::kIvy, shapes[random.below(shapes.size())],
                          place * moved(x, y, 0.012F + deep * far_out - top) * turn *
                              glm::scale(glm::mat4(1.0F), vec3(size)),
                          glm::min(tint, vec3(1.0F)));
    }
}

/// A trunk and its boughs, each with branches, as far as the leaves.
void put_boughs(Assembly& garden, const vec3& centre, float radius_m, base::Random& random) {
    const vec3 bark(0.20F, 0.16F, 0.12F);
    const vec3 foot(centre.x, 0.0F, centre.z);
    const vec3 fork = centre - vec3(0.0F, 0.55F * radius_m, 0.0F);
    garden.put(Surface::kWood, rod(foot, fork, 0.075F, 9), glm::mat4(1.0F), 110U, bark);
    for (int i = 0; i < 9; ++i) {
        const float turn = 0.7F * static_cast<float>(i) + draw(random, -0.3F, 0.3F);
        const float up = draw(random, 0.1F, 0.95F);
        const vec3 way = glm::normalize(vec3(std::sin(turn), 1.4F * up, std::cos(turn)));
        const vec3 middle = fork + way * (0.55F * radius_m);
        const vec3 end =
            middle +
            glm::normalize(way + vec3(0.0F, draw(random, -0.2F, 0.5F), 0.0F)) * (0.55F * radius_m);
        garden.put(Surface::kWood, rod(fork, middle, 0.030F, 7), glm::mat4(1.0F), 111U, bark);
        garden.put(Surface::kWood, rod(middle, end, 0.017F, 6), glm::mat4(1.0F), 112U, bark);
        for (int k = 0; k < 5; ++k) {
            const vec3 from = glm::mix(middle, end, 0.2F * static_cast<float>(k));
            const vec3 aside(draw(random, -1.0F, 1.0F), draw(random, -0.3F, 0.7F),
                             draw(random, -1.0F, 1.0F));
            garden.put(
                Surface::kWood,
                rod(from, from + glm::normalize(way + aside) * (0.38F * radius_m), 0.008F, 5),
                glm::mat4(1.0F), 113U, bark);
        }
    }
}

/// Trees behind the wall: sprigs on a few large balls, darker ones within, on boughs.
void put_trees(Assembly& garden) {
    base::Random random(97);
    struct Crown {
        vec3 centre_m;
        float radius_m;
    };
    const std::array<Crown, 9> crowns{{{{-5.2F, 4.2F, -5.2F}, 1.9F},
                                       {{-2.9F, 3.6F, -5.8F}, 1.6F},
                                       {{-0.6F, 4.5F, -6.4F}, 2.0F},
                                       {{1.8F, 3.5F, -5.6F}, 1.5F},
                                       {{3.9F, 4.3F, -6.0F}, 1.9F},
                                       {{6.4F, 3.8F, -5.4F}, 1.8F},
                                       {{-6.6F, 3.9F, -1.6F}, 1.8F},
                                       {{-7.0F, 3.5F, 1.6F}, 1.7F},
                                       {{8.2F, 4.4F, -6.0F}, 2.2F}}};
    const Mesh sprig = card(1.0F, 0.95F, 0.7F, 0.2F, 1);
    for (const Crown& crown : crowns) {
        put_boughs(garden, crown.centre_m, crown.radius_m, random);
        const int sprigs = static_cast<int>(520.0F * crown.radius_m * crown.radius_m);
        for (int i = 0; i < sprigs; ++i) {
            const float up = draw(random, -1.0F, 1.0F);
            const float turn = draw(random, 0.0F, 6.2832F);
            const float flat = std::sqrt(1.0F - up * up);
            const vec3 way(flat * std::sin(turn), up, flat * std::cos(turn));
            const float lumpy = 0.85F + 0.3F * fbm(way * 2.2F + crown.centre_m, 98, 3);
            const float far_out = draw(random, i % 4 == 0 ? 0.35F : 0.72F, 1.0F);
            const auto own = static_cast<std::uint32_t>(random.below(1U << 20U));
            const glm::mat4 place = moved(crown.centre_m + way * crown.radius_m * far_out * lumpy) *
                                    about_y(turn + draw(random, -0.8F, 0.8F)) *
                                    about_x(draw(random, 0.5F, 2.2F)) *
                                    glm::scale(glm::mat4(1.0F), vec3(draw(random, 0.20F, 0.36F)));
            garden.put_mapped(Surface::kTwig, sprig, place,
                              shade_of(own, 0.45F) *
                                  glm::mix(0.5F, 1.0F, std::max(0.0F, (far_out - 0.72F) / 0.28F)));
        }
    }
}

}  // namespace

Mesh card(float length_m, float width_m, float bend_rad, float fold, int rows, int columns) {
    PatchOptions options;
    options.columns = columns;
    options.rows = rows;
    const float bend = std::max(bend_rad, 1e-3F);
    return patch(options, [&](float u, float v) {
        const float across = 0.5F - u;
        const float angle = bend * v;
        const float lift = fold * width_m * std::abs(across);
        return vec3(width_m * across, length_m * std::sin(angle) / bend + lift * std::sin(angle),
                    length_m * (1.0F - std::cos(angle)) / bend - lift * std::cos(angle));
    });
}

void build_climbers(Assembly& garden) {
    const std::array<float, 2> piers{kPierX[0] - kSideX, kPierX[1] - kSideX};
    put_ivy(garden, moved(kSideX, 0.0F, kWallZ), kRight - kSideX, 7200, 101U, piers);
    put_ivy(garden, moved(kSideX, 0.0F, kFront) * about_y(glm::half_pi<float>()), kFront - kWallZ,
            4200, 103U, {});
    put_trees(garden);
}

}  // namespace obscura::stimuli::garden
