// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/garden/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::garden {
namespace {

using glm::vec3;
using renderer::Mesh;

glm::mat4 on_ground(float x, float z) { return moved(x, ground_m(x, z), z); }

void put_fern(Assembly& garden, float x, float z, float size, std::uint64_t seed) {
    base::Random random(seed);
    const int fronds = 15;
    for (int i = 0; i < fronds; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(fronds);
        const float length = size * draw(random, 0.75F, 1.1F);
        const float turn = 2.399963F * static_cast<float>(i) + draw(random, -0.2F, 0.2F);
        const float tilt = glm::mix(0.15F, 0.75F, t);
        garden.put_mapped(
            Surface::kFern, card(length, 0.36F * length, draw(random, 0.9F, 1.6F), 0.35F, 10),
            on_ground(x, z) * about_y(turn) * moved(0.0F, -0.01F, 0.015F) * about_x(tilt),
            shade_of(static_cast<std::uint32_t>(100 * seed) + static_cast<std::uint32_t>(i),
                     0.35F));
    }
}

/// A clipped or loose ball of sprigs on a stem, darker inside.
void put_shrub(Assembly& garden, const vec3& centre, const vec3& radii, int sprigs,
               const vec3& tint, std::uint64_t seed) {
    base::Random random(seed);
    const std::array<Mesh, 2> shapes{card(1.0F, 0.95F, 0.5F, 0.25F, 2),
                                     card(1.0F, 0.95F, 1.1F, 0.2F, 2)};
    for (int i = 0; i < sprigs; ++i) {
        const float up = 1.0F - 1.85F * (static_cast<float>(i) + 0.5F) / static_cast<float>(sprigs);
        const float turn = 2.399963F * static_cast<float>(i) + draw(random, -0.4F, 0.4F);
        const float flat = std::sqrt(std::max(0.0F, 1.0F - up * up));
        const vec3 way(flat * std::sin(turn), up, flat * std::cos(turn));
        const float far_out = 1.0F - 0.55F * std::pow(draw(random, 0.0F, 1.0F), 2.0F);
        const float lumpy = 0.86F + 0.32F * fbm(way * 1.7F + centre, 33, 3);
        const vec3 at = centre + way * radii * far_out * lumpy;
        if (at.y < ground_m(at.x, at.z)) continue;
        // Sprigs point outwards, with some disorder.
        const float lean = std::acos(glm::clamp(up, -1.0F, 1.0F));
        const auto own = static_cast<std::uint32_t>(random.below(1U << 20U));
        garden.put_mapped(
            Surface::kTwig, shapes[random.below(2)],
            moved(at) * about_y(turn) * about_x(0.75F * lean + draw(random, -0.6F, 0.6F)) *
                about_y(draw(random, -1.5F, 1.5F)) *
                glm::scale(glm::mat4(1.0F), vec3(draw(random, 0.085F, 0.15F))),
            tint * shade_of(own, 0.35F) * glm::mix(0.45F, 1.0F, (far_out - 0.45F) / 0.55F));
    }
}

/// A clump of long arching blades.
void put_sedge(Assembly& garden, float x, float z, float size, std::uint64_t seed) {
    base::Random random(seed);
    for (int i = 0; i < 34; ++i) {
        const float length = size * draw(random, 0.7F, 1.15F);
        garden.put_mapped(
            Surface::kGrass, card(length, 0.42F * length, draw(random, 0.6F, 1.7F), 0.1F, 6),
            on_ground(x + draw(random, -0.03F, 0.03F), z + draw(random, -0.03F, 0.03F)) *
                about_y(draw(random, 0.0F, 6.2832F)) * about_x(draw(random, 0.0F, 0.45F)),
            shade_of(static_cast<std::uint32_t>(i) + 7U, 0.4F));
    }
}

/// Daisies on stems with a rosette of leaves.
void put_daisies(Assembly& garden, float x, float z, int flowers, const vec3& tint,
                 std::uint64_t seed) {
    base::Random random(seed);
    for (int i = 0; i < flowers; ++i) {
        const float turn = draw(random, 0.0F, 6.2832F);
        const float out = 0.22F * std::sqrt(draw(random, 0.0F, 1.0F));
        const float high = draw(random, 0.26F, 0.46F);
        const vec3 root = vec3(x, ground_m(x, z) - 0.01F, z) +
                          0.4F * out * vec3(std::sin(turn), 0.0F, std::cos(turn));
        const vec3 head = root + vec3(out * std::sin(turn), high, out * std::cos(turn) + 0.03F);
        const std::array<vec3, 3> stem{root, glm::mix(root, head, 0.5F) + vec3(0.0F, 0.04F, -0.01F),
                                       head};
        garden.put(Surface::kPebble, pipe(stem, 0.2F, 0.0022F, 5), glm::mat4(1.0F), 90U, kStem);
        // They look up and outwards from their clump, each its own way.
        const float size = draw(random, 0.046F, 0.066F);
        garden.put_mapped(Surface::kFlower, card(size, size, draw(random, 0.2F, 0.9F), 0.0F, 3, 3),
                          moved(head) * about_y(turn + draw(random, -1.0F, 1.0F)) *
                              about_x(-draw(random, 0.55F, 1.6F)) * moved(0.0F, -0.5F * size, 0.0F),
                          tint);
    }
    for (int i = 0; i < 5 * flowers; ++i) {
        const float turn = draw(random, 0.0F, 6.2832F);
        const float out = 0.20F * std::sqrt(draw(random, 0.0F, 1.0F));
        const float px = x + out * std::sin(turn);
        const float pz = z + out * std::cos(turn);
        garden.put_mapped(
            Surface::kTwig,
            card(draw(random, 0.10F, 0.20F), 0.10F, draw(random, 0.3F, 1.2F), 0.3F, 3),
            on_ground(px, pz) * about_y(turn) * about_x(draw(random, 0.1F, 0.8F)),
            shade_of(static_cast<std::uint32_t>(i) + 70U, 0.35F));
    }
}

}  // namespace

void build_border(Assembly& garden) {
    std::uint64_t seed = 201;
    for (const vec3& at :
         {vec3(-3.35F, 0.72F, -2.0F), vec3(-0.62F, 0.66F, -1.95F), vec3(0.05F, 0.50F, -1.62F),
          vec3(1.75F, 0.74F, -2.12F), vec3(2.25F, 0.52F, -1.66F), vec3(3.45F, 0.70F, -1.95F),
          vec3(-2.75F, 0.48F, -1.58F), vec3(1.05F, 0.45F, -1.62F), vec3(4.6F, 0.7F, -1.9F)}) {
        put_fern(garden, at.x, at.z, at.y, seed++);
    }
    const vec3 box(0.85F, 1.0F, 0.85F);
    put_shrub(garden, {-1.30F, 0.52F, -1.92F}, {0.46F, 0.46F, 0.44F}, 1500, box, seed++);
    put_shrub(garden, {0.75F, 0.66F, -2.08F}, {0.52F, 0.60F, 0.42F}, 1700, vec3(1.0F, 0.95F, 0.72F),
              seed++);
    put_shrub(garden, {2.95F, 0.50F, -1.98F}, {0.44F, 0.44F, 0.42F}, 1400, box, seed++);
    put_shrub(garden, {4.10F, 0.80F, -2.1F}, {0.6F, 0.75F, 0.45F}, 1500, vec3(0.9F, 0.9F, 0.8F),
              seed++);
    put_shrub(garden, {-3.45F, 0.55F, 0.2F}, {0.42F, 0.55F, 0.6F}, 1400, vec3(0.95F, 0.95F, 0.7F),
              seed++);
    put_shrub(garden, {-3.5F, 0.45F, 1.7F}, {0.4F, 0.45F, 0.55F}, 1100, box, seed++);
    for (const vec3& at :
         {vec3(-0.15F, 0.34F, -2.15F), vec3(1.42F, 0.38F, -1.60F), vec3(2.62F, 0.36F, -1.50F),
          vec3(-2.2F, 0.30F, -1.52F), vec3(3.9F, 0.34F, -1.55F), vec3(-3.5F, 0.36F, -1.5F)}) {
        put_sedge(garden, at.x, at.z, at.y, seed++);
    }
    put_daisies(garden, 0.42F, -1.58F, 16, vec3(1.0F), seed++);
    put_daisies(garden, 1.98F, -1.55F, 20, vec3(1.0F, 0.72F, 0.85F), seed++);
    put_daisies(garden, -0.95F, -1.50F, 14, vec3(1.0F), seed++);
    put_daisies(garden, 3.2F, -1.55F, 16, vec3(0.86F, 0.72F, 1.0F), seed++);
}

}  // namespace obscura::stimuli::garden
