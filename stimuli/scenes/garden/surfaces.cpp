// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/garden/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::garden {
namespace {

using glm::vec2;
using glm::vec3;

float noise(vec2 uv) { return shared_noise(uv); }

/// Opacity of a shape whose edge is where `inside` (in parts of the texture) is 0.
float edge(float inside) { return glm::clamp(0.5F + 60.0F * inside, 0.0F, 1.0F); }

Texel brick(vec2 uv) {
    const float broad = noise(uv);
    const float fine = noise(uv * 7.0F + 0.4F);
    const float pit = glm::smoothstep(0.25F, 0.45F, noise(uv * 13.0F + 0.2F));
    const float bloom = glm::smoothstep(0.15F, 0.5F, noise(uv * 2.0F + 0.7F));
    Texel texel;
    texel.albedo = vec3(0.88F + 0.2F * broad + 0.16F * fine) * (1.0F - 0.45F * pit);
    texel.albedo = glm::mix(texel.albedo, vec3(1.0F, 1.05F, 1.0F), 0.35F * bloom);
    texel.height_m = 0.0012F * fine - 0.003F * pit;
    return texel;
}

Texel mortar(vec2 uv) {
    const float grain = noise(uv * 17.0F);
    Texel texel;
    texel.albedo = colour<0x968c7a>() * (1.0F + 0.25F * grain + 0.2F * noise(uv * 3.0F));
    texel.height_m = 0.0015F * grain;
    return texel;
}

/// Limestone with lichen and dark algae.
Texel stone(vec2 uv) {
    const float broad = noise(uv);
    const float fine = noise(uv * 9.0F + 0.1F);
    const float grain = noise(uv * 23.0F);
    const float algae = glm::smoothstep(0.05F, 0.5F, noise(uv * 2.0F + 0.31F));
    const CellularNoise spot = cellular(uv * 9.0F + 0.25F * fine, 17, {9, 9});
    const float size = 0.34F * hash_unit(static_cast<int>(spot.id & 0xffffU), 1, 0, 3);
    const float lichen = glm::smoothstep(0.05F, -0.04F, spot.nearest - size + 0.12F * fine);
    Texel texel;
    texel.albedo =
        glm::mix(colour<0x8d8675>(), colour<0xaaa28e>(), glm::clamp(0.5F + broad, 0.0F, 1.0F));
    texel.albedo *= 1.0F + 0.16F * fine + 0.14F * grain;
    texel.albedo = glm::mix(texel.albedo, colour<0x5b5a4b>(), 0.6F * algae);
    texel.albedo = glm::mix(texel.albedo,
                            hash_unit(static_cast<int>(spot.id & 0xffffU), 2, 0, 3) > 0.7F
                                ? colour<0xb08d3e>()
                                : colour<0xb4b49c>(),
                            0.7F * lichen);
    texel.height_m = 0.0016F * fine + 0.0010F * grain + 0.0004F * lichen;
    return texel;
}

Texel clay(vec2 uv) {
    const float bloom = glm::smoothstep(0.0F, 0.5F, noise(uv * 2.0F));
    Texel texel;
    texel.albedo = glm::mix(colour<0xa2603f>(), colour<0xb99780>(), 0.6F * bloom) *
                   (1.0F + 0.15F * noise(uv * 7.0F));
    texel.height_m = 0.0004F * noise(uv * 7.0F);
    return texel;
}

/// Crumbs of earth of several sizes in lumps, darker between them, with a little chaff. Covers 0.8
/// m.
Texel soil(vec2 uv) {
    const float damp = noise(uv + 0.13F);
    const float lumps = noise(uv * 4.0F + 0.3F);
    const CellularNoise crumb = cellular(uv * 40.0F + 0.6F * noise(uv * 9.0F), 131, {40, 40});
    const CellularNoise grain = cellular(uv * 104.0F, 132, {104, 104});
    const float own = hash_unit(static_cast<int>(crumb.id & 0xffffU), 0, 0, 2);
    const float fine = hash_unit(static_cast<int>(grain.id & 0xffffU), 0, 0, 2);
    const float between = glm::smoothstep(0.35F, 0.8F, crumb.nearest);
    Texel texel;
    texel.albedo = glm::mix(colour<0x3a2e25>(), colour<0x574637>(),
                            glm::clamp(0.45F + 0.5F * lumps + 0.35F * (own - 0.5F), 0.0F, 1.0F));
    texel.albedo *= (0.86F + 0.28F * fine) * (1.0F - 0.45F * between) * (1.0F + 0.18F * damp);
    if (fine > 0.985F) texel.albedo = colour<0x8a7458>();
    texel.height_m = -0.005F * crumb.nearest - 0.0015F * grain.nearest + 0.004F * lumps;
    return texel;
}

/// Small stones between the single ones. Covers 0.6 m.
Texel gravel(vec2 uv) {
    const CellularNoise grain = cellular(uv * 52.0F, 141, {52, 52});
    const CellularNoise larger = cellular(uv * 23.0F, 142, {23, 23});
    const bool big = larger.nearest < 0.36F;
    const CellularNoise& cell = big ? larger : grain;
    const float own = hash_unit(static_cast<int>(cell.id & 0xffffU), 0, 0, 2);
    const float warm = hash_unit(static_cast<int>(cell.id & 0xffffU), 1, 0, 2);
    Texel texel;
    texel.albedo = glm::mix(colour<0x8a7c66>(), colour<0xb5a78d>(), own) *
                   glm::mix(vec3(0.95F, 0.98F, 1.03F), vec3(1.05F, 0.97F, 0.86F), warm);
    texel.albedo *= 1.0F - 0.55F * glm::smoothstep(0.25F, 0.7F, cell.nearest * (big ? 1.6F : 1.0F));
    texel.height_m = big ? 0.007F - 0.015F * larger.nearest : 0.003F - 0.006F * grain.nearest;
    return texel;
}

Texel pebble(vec2 uv) {
    Texel texel;
    texel.albedo = vec3(0.92F + 0.16F * noise(uv) + 0.08F * noise(uv * 7.0F));
    texel.height_m = 0.0003F * noise(uv * 5.0F);
    return texel;
}

/// Short grass seen from above, clover and bare patches. Covers 1.2 m.
Texel turf(vec2 uv) {
    const float blade = noise(uv * vec2(61.0F, 17.0F)) + noise(uv * vec2(19.0F, 53.0F) + 0.3F);
    const float patchy = noise(uv * 2.0F);
    const float bare = glm::smoothstep(0.25F, 0.5F, noise(uv * 3.0F + 0.7F));
    Texel texel;
    texel.albedo = glm::mix(colour<0x35411e>(), colour<0x5b6833>(),
                            glm::clamp(0.5F + 0.5F * blade + 0.4F * patchy, 0.0F, 1.0F));
    texel.albedo = glm::mix(texel.albedo, colour<0x594a35>(), 0.55F * bare);
    texel.height_m = 0.004F * blade;
    return texel;
}

Texel zinc(vec2 uv) {
    const CellularNoise spangle = cellular(uv * 12.0F, 41, {12, 12});
    const float stain = glm::smoothstep(0.1F, 0.5F, noise(uv * 2.0F));
    Texel texel;
    texel.albedo = colour<0x8a8e8e>() *
                   (0.85F + 0.22F * hash_unit(static_cast<int>(spangle.id & 0xffffU), 0, 0, 6));
    texel.albedo *= 1.0F - 0.3F * stain;
    texel.height_m = 0.00006F * noise(uv * 5.0F);
    return texel;
}

/// Weathered grey-brown, grain along v.
Texel wood(vec2 uv) {
    const float grain =
        fbm(vec2(uv.x + 0.01F * noise(uv), uv.y) * vec2(60.0F, 3.0F), 82, 3, {60, 3});
    const float split = glm::smoothstep(0.35F, 0.5F, fbm(uv * vec2(22.0F, 2.0F), 84, 3, {22, 2}));
    Texel texel;
    texel.albedo = glm::mix(colour<0x6a5c4b>(), colour<0x95887a>(),
                            glm::clamp(0.5F + 0.8F * grain, 0.0F, 1.0F)) *
                   (1.0F - 0.6F * split);
    texel.height_m = 0.0008F * grain - 0.003F * split;
    return texel;
}

/// Green of a leaf: mottled, with pale veins (1 on them).
vec3 leaf_green(vec2 uv, float vein, const vec3& dark, const vec3& light) {
    const float mottle = glm::clamp(0.5F + 0.7F * noise(uv) + 0.15F * noise(uv * 6.0F), 0.0F, 1.0F);
    return glm::mix(glm::mix(dark, light, mottle), light * 1.45F, 0.6F * vein);
}

/// Five-pointed, its stalk at v = 0.
Texel ivy(vec2 uv) {
    const vec2 p = uv - vec2(0.5F, 0.34F);
    const float r = glm::length(p);
    const float angle = std::atan2(p.x, p.y);
    constexpr std::array<vec3, 5> kLobes{{{0.0F, 0.64F, 0.62F},
                                          {1.12F, 0.50F, 0.56F},
                                          {-1.12F, 0.50F, 0.56F},
                                          {2.25F, 0.36F, 0.62F},
                                          {-2.25F, 0.36F, 0.62F}}};
    float reach = 0.16F;
    float vein = 0.0F;
    for (const vec3& lobe : kLobes) {
        const float off = std::abs(angle - lobe.x);
        reach = std::max(reach, lobe.y * (1.0F - 0.62F * std::pow(off / lobe.z, 1.15F)));
        const float side = r * std::sin(std::min(off, 1.5F));
        if (off < 1.2F && r < lobe.y)
            vein = std::max(vein, 1.0F - glm::smoothstep(0.004F, 0.014F, side));
    }
    const float stalk = 0.014F - std::max(std::abs(p.x), p.y);
    Texel texel;
    texel.albedo = leaf_green(uv, vein, colour<0x25401c>(), colour<0x47662f>());
    texel.height_m = 0.0008F * vein;
    texel.opacity = std::max(edge(std::min(reach, 0.63F) - r), edge(stalk));
    return texel;
}

/// Pinnae on both sides of a stem, longest a third of the way up.
Texel fern(vec2 uv) {
    constexpr float kPairs = 26.0F;
    const float across = std::abs(uv.x - 0.5F) * 2.0F;
    const float stem = 0.022F * (1.1F - uv.y) - 0.5F * across;
    const float start = 0.10F;
    const float along = (uv.y - start) / (0.985F - start) * kPairs;
    const float shifted = along - 0.9F * across + (uv.x > 0.5F ? 0.5F : 0.0F);
    const float index = std::floor(shifted);
    const float in = shifted - index - 0.5F;
    const float t = glm::clamp((index + 0.5F) / kPairs, 0.0F, 1.0F);
    const float length =
        0.97F *
        std::pow(std::sin(glm::pi<float>() * std::pow(1.0F - t, 1.6F) * 0.96F + 0.04F), 0.8F) *
        (1.0F - 0.25F * t);
    const float s = across / std::max(length, 0.02F);
    const float lobes = 1.0F + 0.28F * std::sin(across * 62.0F);
    const float half = 0.44F * std::pow(std::max(0.0F, 1.0F - s), 0.55F) * lobes;
    const bool on = along > -0.3F && along < kPairs && s < 1.0F;
    Texel texel;
    const float vein = 1.0F - glm::smoothstep(0.0F, 0.09F, std::abs(in));
    texel.albedo = leaf_green(uv, std::max(0.5F * vein, stem > 0.0F ? 1.0F : 0.0F),
                              colour<0x35561f>(), colour<0x6a8a35>());
    texel.height_m = 0.0006F * vein;
    texel.opacity = std::max(
        edge(stem), on ? glm::clamp(0.5F + 6.0F * (half - std::abs(in)), 0.0F, 1.0F) : 0.0F);
    return texel;
}

/// A sprig: a stem with three oval leaves to each side and one at its end, apart from each other so
/// that they do not run together in the coarser levels that a tree's crown is drawn with.
Texel twig(vec2 uv) {
    constexpr int kLeaves = 7;
    Texel texel;
    texel.opacity = edge(0.008F - std::max(std::abs(uv.x - 0.5F), uv.y - 0.8F));
    float vein = texel.opacity;
    float own = 0.5F;
    for (int i = 0; i < kLeaves; ++i) {
        const bool last = i + 1 == kLeaves;
        const float side = last ? 0.0F : (i % 2 == 0 ? 1.0F : -1.0F);
        const float turn = last ? 0.0F : 0.9F + 0.22F * (hash_unit(i, 1, 0, 8) - 0.5F);
        const vec2 way(side * std::sin(turn), std::cos(turn));
        const vec2 p = uv - vec2(0.5F, last ? 0.70F : 0.05F + 0.115F * static_cast<float>(i));
        const float length = last ? 0.28F : 0.38F - 0.018F * static_cast<float>(i);
        const float along = glm::dot(p, way) / length;
        const float off = (p.x * way.y - p.y * way.x) / length;
        if (along < 0.0F || along > 1.0F) continue;
        const float half =
            0.20F * std::pow(std::sin(glm::pi<float>() * std::pow(along, 0.85F)), 0.7F);
        const float opacity = glm::clamp(0.5F + 22.0F * (half - std::abs(off)), 0.0F, 1.0F);
        if (opacity > 0.5F) {
            vein = 1.0F - glm::smoothstep(0.0F, 0.05F, std::abs(off));
            own = hash_unit(i, 0, 0, 8);
        }
        texel.opacity = std::max(texel.opacity, opacity);
    }
    texel.albedo =
        leaf_green(uv, 0.7F * vein, colour<0x314a1e>(), colour<0x5d7a34>()) * (0.75F + 0.5F * own);
    texel.height_m = 0.0006F * vein;
    return texel;
}

/// Nine blades from one root.
Texel grass(vec2 uv) {
    Texel texel;
    texel.opacity = 0.0F;
    float own = 0.5F;
    for (int i = 0; i < 9; ++i) {
        const float root = 0.5F + 0.045F * (static_cast<float>(i) - 4.0F);
        const float lean =
            0.105F * (static_cast<float>(i) - 4.0F) + 0.10F * (hash_unit(i, 1, 0, 4) - 0.5F);
        const float high = 0.62F + 0.36F * hash_unit(i, 0, 0, 4);
        if (uv.y > high) continue;
        const float t = uv.y / high;
        const float inside =
            0.024F * std::pow(1.0F - t, 0.6F) - std::abs(uv.x - root - lean * t * t);
        const float opacity = edge(1.3F * inside);
        if (opacity > 0.5F) own = hash_unit(i, 2, 0, 4);
        texel.opacity = std::max(texel.opacity, opacity);
    }
    texel.albedo = glm::mix(colour<0x3e4f1f>(), colour<0x7f9145>(),
                            glm::clamp(0.25F + 0.5F * uv.y + 0.4F * (own - 0.3F), 0.0F, 1.0F));
    return texel;
}

/// A daisy from above, its middle at the middle.
Texel flower(vec2 uv) {
    const vec2 p = (uv - 0.5F) * 2.0F;
    const float r = glm::length(p);
    const float angle = std::atan2(p.x, p.y);
    const float petal = std::abs(std::sin(7.5F * angle));
    const float reach = 0.62F + 0.34F * std::pow(petal, 0.45F);
    Texel texel;
    texel.albedo = r < 0.24F ? colour<0xc99a23>() * (0.7F + 0.5F * noise(uv * 7.0F))
                             : vec3(0.80F, 0.78F, 0.80F) * (0.72F + 0.28F * petal);
    texel.opacity = glm::clamp(0.5F + 20.0F * (reach - r), 0.0F, 1.0F);
    if (r > 0.3F && petal < 0.16F) texel.opacity = 0.0F;
    return texel;
}

constexpr std::array<Finish, 15> kFinishes{{
    {"brick", brick, 256, 256, 0.5F, 0.02F, 8.0F},
    {"mortar", mortar, 256, 256, 0.6F, 0.0F, 8.0F},
    {"stone", stone, 768, 768, 1.1F, 0.03F, 10.0F},
    {"clay", clay, 256, 256, 0.5F, 0.03F, 10.0F},
    {"soil", soil, 512, 512, 0.8F, 0.0F, 8.0F},
    {"gravel", gravel, 512, 512, 0.6F, 0.02F, 10.0F},
    {"pebble", pebble, 128, 128, 0.1F, 0.04F, 16.0F},
    {"turf", turf, 512, 512, 1.2F, 0.0F, 8.0F},
    {"zinc", zinc, 256, 256, 0.4F, 0.25F, 30.0F, true},  // sheets without an inner side
    {"wood", wood, 256, 256, 1.0F, 0.02F, 8.0F},
    {"ivy", ivy, 256, 256, 1.0F, 0.025F, 12.0F, true, true},
    {"fern", fern, 256, 1024, 1.0F, 0.02F, 12.0F, true, true},
    {"twig", twig, 256, 256, 1.0F, 0.025F, 12.0F, true, true},
    {"grass", grass, 256, 256, 1.0F, 0.02F, 12.0F, true, true},
    {"flower", flower, 128, 128, 1.0F, 0.02F, 8.0F, true, true},
}};

}  // namespace

std::span<const Finish> finishes() { return kFinishes; }

}  // namespace obscura::stimuli::garden
