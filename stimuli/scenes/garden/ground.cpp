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

Mesh strip(float z0, float z1, float cell_m) {
    const float x0 = kSideX - 0.1F;
    const float x1 = kRight;
    PatchOptions options;
    options.size_m = {x1 - x0, -(z1 - z0)};
    options.columns = static_cast<int>((x1 - x0) / cell_m);
    options.rows = std::max(2, static_cast<int>((z1 - z0) / cell_m));
    Mesh mesh = patch(options, [&](float u, float v) {
        const float x = x0 + (x1 - x0) * u;
        const float z = z1 + (z0 - z1) * v;
        return vec3(x, ground_m(x, z), z);
    });
    for (renderer::Vertex& vertex : mesh.vertices) vertex.tangent.w = -1.0F;
    return mesh;
}

/// A round stone of unit radius, pushed about and flattened.
Mesh stone_shape(std::uint32_t seed) {
    PatchOptions options;
    options.columns = 6;
    options.rows = 4;
    options.closed_u = true;
    Mesh mesh = patch(options, [&](float u, float v) {
        const float a = glm::two_pi<float>() * u;
        const float b = glm::pi<float>() * (v - 0.5F);
        const vec3 way(std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b));
        const float r =
            1.0F + 0.28F * gradient_noise(1.6F * way + 3.0F * static_cast<float>(seed), seed);
        return way * r * vec3(1.0F, 0.62F, 0.8F);
    });
    // The shape is as large as its place scales it; its texture is that of a centimetre.
    project_box_uv(mesh);
    for (renderer::Vertex& vertex : mesh.vertices) vertex.uv *= 0.01F;
    return mesh;
}

/// What the kerb holds back: without it one would see below the bed between two of its stones.
void put_bed_face(Assembly& garden) {
    PatchOptions options;
    options.columns = 100;
    options.rows = 1;
    options.size_m = {kRight - kSideX, 0.3F};
    const float z = kBedFront - 0.001F;
    garden.put(Surface::kSoil,
               patch(options,
                     [&](float u, float v) {
                         const float x = glm::mix(kSideX - 0.1F, kRight, u);
                         return vec3(x, glm::mix(-0.12F, ground_m(x, z), v), z);
                     }),
               glm::mat4(1.0F), 4U, vec3(0.8F));
}

/// Clods on the bed.
void put_clods(Assembly& garden) {
    std::array<Mesh, 4> shapes;
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        shapes[i] = stone_shape(60U + i);
        for (renderer::Vertex& vertex : shapes[i].vertices) vertex.uv *= 3.0F;
    }
    base::Random random(74);
    for (int i = 0; i < 700; ++i) {
        const float x = draw(random, -3.8F, 4.6F);
        const float z = draw(random, kWallZ + 0.1F, kBedFront - 0.07F);
        const float size = 0.006F + 0.024F * std::pow(draw(random, 0.0F, 1.0F), 3.0F);
        const auto own = static_cast<std::uint32_t>(random.below(1U << 20U));
        garden.put(Surface::kSoil, shapes[random.below(shapes.size())],
                   moved(x, ground_m(x, z) + 0.2F * size, z) * about_y(draw(random, 0.0F, 6.28F)) *
                       about_x(draw(random, -0.5F, 0.5F)) * glm::scale(glm::mat4(1.0F), vec3(size)),
                   own, shade_of(own, 0.3F));
    }
}

vec3 pebble_colour(std::uint32_t seed) {
    const int i = static_cast<int>(seed);
    const vec3 warm =
        glm::mix(vec3(0.46F, 0.38F, 0.27F), vec3(0.37F, 0.35F, 0.32F), hash_unit(i, 0, 0, 61));
    return warm * (0.65F + 0.65F * hash_unit(i, 1, 0, 61));
}

void put_pebbles(Assembly& garden) {
    std::array<Mesh, 5> shapes;
    for (std::uint32_t i = 0; i < shapes.size(); ++i) shapes[i] = stone_shape(70U + i);
    base::Random random(71);
    for (int i = 0; i < 4200; ++i) {
        const float x = draw(random, -3.8F, 4.2F);
        const float z = draw(random, kBedFront + 0.05F, kPathFront - 0.04F);
        const float size = draw(random, 0.007F, 0.014F) * (random.below(12) == 0 ? 1.7F : 1.0F);
        const auto own = static_cast<std::uint32_t>(random.below(1U << 20U));
        garden.put(Surface::kPebble, shapes[random.below(shapes.size())],
                   moved(x, ground_m(x, z) + 0.35F * size, z) * about_y(draw(random, 0.0F, 6.28F)) *
                       about_x(draw(random, -0.4F, 0.4F)) * glm::scale(glm::mat4(1.0F), vec3(size)),
                   own, pebble_colour(own));
    }
}

/// Stones on edge between bed, path and lawn.
void put_edging(Assembly& garden) {
    base::Random random(73);
    for (const float z : {kBedFront, kPathFront}) {
        float x = kSideX + 0.02F;
        while (x < kRight - 0.2F) {
            const float length = draw(random, 0.24F, 0.42F);
            const auto own = static_cast<std::uint32_t>(random.below(1U << 20U));
            const float high = z < 0.0F ? 0.13F : 0.08F;
            garden.put(
                Surface::kStone, bevelled_box({length - 0.012F, high + 0.08F, 0.085F}, 0.016F),
                moved(x + 0.5F * length,
                      0.5F * (high + 0.08F) - 0.08F + draw(random, -0.008F, 0.008F),
                      z + draw(random, -0.006F, 0.006F)) *
                    about_y(draw(random, -0.03F, 0.03F)) * about_x(draw(random, -0.05F, 0.05F)),
                own, shade_of(own, 0.35F));
            x += length;
        }
    }
}

void put_lawn(Assembly& garden) {
    base::Random random(79);
    for (int i = 0; i < 5200; ++i) {
        const float x = draw(random, -3.8F, 4.4F);
        const float near = draw(random, 0.0F, 1.0F);
        const float z = kPathFront + 0.05F + 3.4F * near * near;
        const float size = draw(random, 0.05F, 0.11F);
        const auto own = static_cast<std::uint32_t>(random.below(1U << 20U));
        garden.put_mapped(
            Surface::kGrass, card(size, 1.05F * size, draw(random, 0.1F, 0.9F), 0.2F, 2),
            moved(x, ground_m(x, z) - 0.004F, z) * about_y(draw(random, 0.0F, 6.28F)) *
                about_x(draw(random, -0.2F, 0.3F)),
            shade_of(own, 0.45F));
    }
    // The short grass between them, where one stands near enough to see that turf is blades.
    for (int i = 0; i < 11000; ++i) {
        const float x = draw(random, -3.6F, 4.2F);
        const float z = kPathFront + 0.03F + 1.7F * draw(random, 0.0F, 1.0F);
        const float size = draw(random, 0.045F, 0.075F);
        const auto own = static_cast<std::uint32_t>(random.below(1U << 20U));
        garden.put_mapped(
            Surface::kGrass, card(size, 0.62F * size, draw(random, 0.2F, 1.1F), 0.2F, 1),
            moved(x, ground_m(x, z) - 0.003F, z) * about_y(draw(random, 0.0F, 6.28F)) *
                about_x(draw(random, -0.3F, 0.5F)),
            shade_of(own, 0.40F) * vec3(0.90F, 0.94F, 0.90F));
    }
    for (int i = 0; i < 130; ++i) {
        const float x = draw(random, -2.5F, 3.4F);
        const float z = draw(random, kPathFront + 0.1F, 2.6F);
        const float high = draw(random, 0.04F, 0.075F);
        const vec3 root(x, ground_m(x, z), z);
        const vec3 head =
            root + vec3(draw(random, -0.02F, 0.02F), high, draw(random, -0.01F, 0.03F));
        garden.put(Surface::kPebble, rod(root, head, 0.0014F, 4), glm::mat4(1.0F), 80U, kStem);
        garden.put_mapped(Surface::kFlower, card(0.022F, 0.022F, 0.3F, 0.0F, 2),
                          moved(head + vec3(0.0F, 0.001F, 0.0F)) *
                              about_y(draw(random, 0.0F, 6.28F)) *
                              about_x(-draw(random, 1.1F, 1.8F)) * moved(0.0F, -0.011F, 0.0F));
    }
}

/// Leaves that fell on the path and the bench's foot.
void put_fallen_leaves(Assembly& garden) {
    base::Random random(83);
    for (int i = 0; i < 260; ++i) {
        const float x = draw(random, -3.6F, 3.8F);
        const float z = draw(random, kBedFront + 0.06F, kPathFront + 0.5F);
        const float size = draw(random, 0.035F, 0.07F);
        const vec3 brown = glm::mix(vec3(0.95F, 0.62F, 0.30F), vec3(0.75F, 0.36F, 0.22F),
                                    draw(random, 0.0F, 1.0F));
        garden.put_mapped(
            Surface::kIvy,
            card(size, 0.9F * size, draw(random, 0.4F, 1.4F), draw(random, 0.1F, 0.4F), 2),
            moved(x, ground_m(x, z) + 0.012F, z) * about_y(draw(random, 0.0F, 6.28F)) *
                about_x(draw(random, 1.2F, 1.55F)),
            brown);
    }
}

}  // namespace

float ground_m(float x, float z) {
    const float bumps = 0.5F * fbm(vec2(x, z) * 0.9F, 91, 3);
    if (z < kBedFront) {
        const float in = glm::smoothstep(kBedFront, kBedFront - 0.5F, z);
        return 0.04F + 0.06F * in + 0.05F * bumps + 0.025F * fbm(vec2(x, z) * 6.0F, 92, 3);
    }
    if (z < kPathFront) return 0.012F * bumps;
    return 0.03F + 0.05F * bumps * glm::smoothstep(kPathFront, kPathFront + 0.4F, z);
}

void build_ground(Assembly& garden) {
    garden.put(Surface::kSoil, strip(kWallZ - 0.02F, kBedFront - 0.001F, 0.05F), glm::mat4(1.0F),
               1U);
    garden.put(Surface::kGravel, strip(kBedFront, kPathFront - 0.001F, 0.12F), glm::mat4(1.0F), 2U);
    garden.put(Surface::kTurf, strip(kPathFront, kFront, 0.12F), glm::mat4(1.0F), 3U);
    put_bed_face(garden);
    put_clods(garden);
    put_pebbles(garden);
    put_edging(garden);
    put_lawn(garden);
    put_fallen_leaves(garden);
}

}  // namespace obscura::stimuli::garden
