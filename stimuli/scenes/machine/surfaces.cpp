// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/machine/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::machine {
namespace {

using glm::vec2;
using glm::vec3;

float noise(vec2 uv) { return shared_noise(uv); }

/// Where a coat came off: ragged spots of all sizes in `share` of the cells, crowded here and
/// absent there. 1 inside.
float chipped(vec2 uv, int cells, float share, float ragged) {
    constexpr int kSeed = 57;
    const CellularNoise spot = cellular(uv * static_cast<float>(cells), kSeed, {cells, cells});
    const int id = static_cast<int>(spot.id & 0xffffU);
    const float crowd = glm::smoothstep(-0.1F, 0.35F, noise(uv + 0.21F));
    if (hash_unit(id, 0, 0, kSeed) > share * 2.0F * crowd) return 0.0F;
    const float size = 0.03F + 0.42F * std::pow(hash_unit(id, 1, 0, kSeed), 2.5F);
    return glm::smoothstep(0.03F, -0.03F, spot.nearest - size + 0.22F * ragged);
}

/// Machine paint with a soft gloss, dusty in large patches and chipped to the primer.
Texel enamel(vec2 uv) {
    const float broad = noise(uv);
    const float fine = noise(uv * 11.0F + 0.3F);
    const float peel = noise(uv * 37.0F);
    const float dust = glm::smoothstep(0.0F, 0.7F, broad + 0.3F * noise(uv * 3.0F + 0.77F));
    const float chip = chipped(uv, 11, 0.10F, fine);
    Texel texel;
    texel.albedo = vec3(0.97F + 0.03F * fine) * (1.0F - 0.14F * dust);
    texel.albedo = glm::mix(texel.albedo, vec3(0.50F, 0.40F, 0.34F), chip);
    texel.height_m = 0.00012F * fine + 0.00004F * peel - 0.0005F * chip;
    texel.roughness = 0.30F + 0.05F * peel + 0.30F * dust + 0.3F * chip;
    return texel;
}

/// Rough from the mould, oiled nearly black, rust only where hands never come.
Texel cast(vec2 uv) {
    const float broad = noise(uv);
    const float fine = noise(uv * 9.0F + 0.2F);
    const float grain = noise(uv * 31.0F + 0.6F);
    const float rust = glm::smoothstep(0.35F, 0.75F, noise(uv * 2.0F + 0.4F) + 0.3F * fine);
    Texel texel;
    texel.albedo = glm::mix(colour<0x434445>(), colour<0x5c4436>(), 0.45F * rust);
    texel.albedo *= 1.0F + 0.10F * broad + 0.06F * fine + 0.22F * grain;
    texel.height_m = 0.0004F * fine + 0.0006F * grain;
    texel.roughness = 0.58F + 0.10F * grain + 0.2F * rust;
    return texel;
}

/// Turned or planed: fine lines along u under a film of oil.
Texel steel(vec2 uv) {
    const float turned = noise(uv * vec2(1.0F, 41.0F));
    const float fine = noise(uv * vec2(2.0F, 61.0F) + 0.5F);
    const float oil = glm::smoothstep(0.0F, 0.7F, noise(uv + 0.7F));
    Texel texel;
    texel.albedo = colour<0x84888c>() * (1.0F + 0.10F * turned + 0.09F * fine);
    texel.albedo = glm::mix(texel.albedo, colour<0x62605c>(), 0.30F * oil);
    texel.height_m = 0.00003F * turned + 0.00003F * fine;
    texel.roughness = 0.26F + 0.06F * turned + 0.10F * oil;
    return texel;
}

/// Polished now and then: clear in the middle of a face, brown in patches with soft borders.
Texel brass(vec2 uv) {
    const float tarnish = glm::smoothstep(0.05F, 0.8F, noise(uv) + 0.2F * noise(uv * 5.0F));
    const float wiped = noise(uv * vec2(3.0F, 41.0F));
    Texel texel;
    texel.albedo = glm::mix(colour<0xa88748>(), colour<0x7d6536>(), tarnish) *
                   (1.0F + 0.07F * wiped + 0.04F * noise(uv * 8.0F));
    texel.height_m = 0.00003F * wiped;
    texel.roughness = 0.24F + 0.05F * wiped + 0.22F * tarnish;
    return texel;
}

Texel copper(vec2 uv) {
    const float tarnish = glm::smoothstep(-0.2F, 0.8F, noise(uv) + 0.2F * noise(uv * 7.0F));
    const float verdigris = glm::smoothstep(0.52F, 0.66F, noise(uv * 3.0F + 0.4F));
    Texel texel;
    texel.albedo = glm::mix(colour<0x9c6248>(), colour<0x6b4435>(), tarnish) *
                   (1.0F + 0.05F * noise(uv * 23.0F));
    texel.albedo = glm::mix(texel.albedo, colour<0x64806f>(), 0.45F * verdigris);
    texel.height_m = 0.00004F * noise(uv * 23.0F);
    texel.roughness = 0.32F + 0.25F * tarnish + 0.2F * verdigris;
    return texel;
}

Texel rubber(vec2 uv) {
    Texel texel;
    texel.albedo = colour<0x2b2a29>() * (1.0F + 0.3F * noise(uv) + 0.15F * noise(uv * 9.0F));
    texel.height_m = 0.0001F * noise(uv * 9.0F);
    return texel;
}

/// A power-floated floor with oil stains, cracks and a joint each 2 m. Covers 4 m.
Texel concrete(vec2 uv) {
    const float broad = noise(uv);
    const float medium = noise(uv * 4.0F + 0.3F);
    const float fine = noise(uv * 29.0F);
    const float stain = glm::smoothstep(0.25F, 0.75F, noise(uv * 3.0F + 0.63F) + 0.2F * medium);
    const CellularNoise stone = cellular(uv * 90.0F, 72, {90, 90});
    const float pebble = 0.5F - hash_unit(static_cast<int>(stone.id & 0xffffU), 0, 0, 72);
    const CellularNoise crack = cellular(uv * 5.0F + 0.12F * medium, 71, {5, 5});
    const float line = (1.0F - glm::smoothstep(0.0F, 0.006F, crack.second - crack.nearest)) *
                       glm::smoothstep(0.0F, 0.3F, broad);
    Texel texel;
    texel.albedo = glm::mix(colour<0x8b867c>(), colour<0xaaa497>(),
                            glm::clamp(0.5F + 0.8F * broad, 0.0F, 1.0F));
    texel.albedo *=
        (1.0F + 0.06F * medium + 0.10F * fine + 0.10F * pebble) * (1.0F - 0.30F * stain);
    texel.albedo *= 1.0F - 0.5F * line;
    texel.height_m = 0.0012F * medium + 0.0005F * fine - 0.002F * line;
    return texel;
}

/// Brick in running bond, painted long ago. Covers 2.56 m x 2.56 m: 10 x 32 bricks.
Texel brick(vec2 uv) {
    const glm::ivec2 counts(10, 32);
    const vec2 q(uv.x * 10.0F, uv.y * 32.0F);
    const int row = static_cast<int>(q.y);
    const float shifted = q.x + (row % 2 == 0 ? 0.0F : 0.5F);
    const int column = static_cast<int>(shifted) % counts.x;
    const vec2 in(shifted - std::floor(shifted), q.y - std::floor(q.y));
    const float rough = noise(uv * 12.0F + 0.17F);
    const float edge_m =
        std::min(std::min(in.x, 1.0F - in.x) * 0.256F, std::min(in.y, 1.0F - in.y) * 0.08F) +
        0.0025F * rough;
    const float inside = glm::smoothstep(0.004F, 0.009F, edge_m);
    const float flaked = chipped(uv, 14, 0.16F, rough);
    const float soot = noise(uv * 2.0F + 0.33F);
    const float own = hash_unit(column, row, 0, 12);
    vec3 clay = glm::mix(colour<0x8a4f3b>(), colour<0xa8705a>(), own);
    vec3 paint = colour<0xc9c0a6>() * (0.90F + 0.07F * own + 0.16F * soot);
    Texel texel;
    texel.albedo = glm::mix(paint, glm::mix(colour<0x8f877a>(), clay, inside), flaked);
    texel.albedo *= (0.72F + 0.28F * inside) * (1.0F + 0.08F * rough);
    texel.height_m = 0.004F * inside + 0.0012F * rough - 0.0008F * flaked;
    return texel;
}

/// Glazed tiles, 150 mm x 75 mm. Covers 1.5 m: 10 x 20.
Texel tile(vec2 uv) {
    const vec2 q(uv.x * 10.0F, uv.y * 20.0F);
    const int row = static_cast<int>(q.y);
    const float shifted = q.x + (row % 2 == 0 ? 0.0F : 0.5F);
    const int column = static_cast<int>(shifted) % 10;
    const vec2 in(shifted - std::floor(shifted), q.y - std::floor(q.y));
    const float edge_m =
        std::min(std::min(in.x, 1.0F - in.x) * 0.15F, std::min(in.y, 1.0F - in.y) * 0.075F);
    const float inside = glm::smoothstep(0.0015F, 0.004F, edge_m);
    const float own = hash_unit(column, row, 0, 33);
    const float crazed = noise(uv * 12.0F + own);
    Texel texel;
    texel.albedo = glm::mix(colour<0x4e6a5c>(), colour<0x5d7c6a>(), own) *
                   (1.0F + 0.10F * crazed + 0.10F * noise(uv));
    texel.albedo = glm::mix(colour<0x5a564c>(), texel.albedo, inside);
    texel.height_m = 0.0022F * inside + 0.0004F * (own - 0.5F);
    return texel;
}

Texel zinc(vec2 uv) {
    const CellularNoise spangle = cellular(uv * 14.0F, 41, {14, 14});
    const float tone = hash_unit(static_cast<int>(spangle.id & 0xffffU), 0, 0, 6);
    Texel texel;
    texel.albedo = colour<0x8e9294>() * (0.82F + 0.26F * tone + 0.18F * noise(uv * 2.0F));
    texel.height_m = 0.00008F * tone;
    return texel;
}

/// Grain along v. Covers 1 m.
Texel wood(vec2 uv) {
    const float bend = noise(uv * vec2(1.0F, 1.0F));
    const float grain = fbm(vec2(uv.x + 0.01F * bend, uv.y) * vec2(40.0F, 3.0F), 82, 4, {40, 3});
    Texel texel;
    texel.albedo = glm::mix(colour<0x5b422b>(), colour<0x957250>(),
                            glm::clamp(0.5F + 0.9F * grain, 0.0F, 1.0F)) *
                   (1.0F + 0.3F * bend);
    texel.height_m = 0.0008F * grain;
    return texel;
}

/// A white dial with a scale over three quarters of a turn and a hand.
Texel dial(vec2 uv) {
    const vec2 p = (uv - 0.5F) * 2.0F;
    const float r = glm::length(p);
    const float turn = std::atan2(p.x, p.y);  // 0 is down, because v goes down
    const float scale = glm::clamp((turn + glm::pi<float>()) / glm::two_pi<float>(), 0.0F, 1.0F);
    const float step = std::abs(glm::fract(scale * 40.0F) - 0.5F) * 2.0F;
    const bool on_scale = std::abs(turn) < 2.45F;
    const bool mark = on_scale && r > 0.72F && r < 0.86F && step > 0.72F;
    const bool arc = on_scale && std::abs(r - 0.87F) < 0.012F;
    const vec2 way = glm::normalize(vec2(0.55F, -0.83F));
    const float along = glm::dot(p, way);
    const float off = std::abs(p.x * way.y - p.y * way.x);
    const bool hand = (along > -0.2F && along < 0.74F && off < 0.03F) || r < 0.09F;
    Texel texel;
    texel.albedo = colour<0xd8d3c0>() * (1.0F + 0.08F * noise(uv));
    if (mark || arc || hand) texel.albedo = colour<0x1c1b1a>();
    return texel;
}

Texel dark(vec2) {
    Texel texel;
    texel.albedo = vec3(0.03F);
    return texel;
}

constexpr std::array<Finish, 13> kFinishes{{
    {"enamel", enamel, 768, 768, 0.9F, 0.10F, kBaked},
    {"cast-iron", cast, 512, 512, 0.6F, 0.10F, kBaked},
    {"steel", steel, 512, 512, 0.5F, 0.55F, kBaked},
    {"brass", brass, 256, 256, 0.3F, 0.55F, kBaked},
    {"copper", copper, 256, 256, 0.4F, 0.45F, kBaked},
    {"rubber", rubber, 128, 128, 0.2F, 0.06F, 12.0F},
    {"concrete", concrete, 1024, 1024, 4.0F, 0.05F, 14.0F},
    {"brick", brick, 1024, 1024, 2.56F, 0.03F, 10.0F},
    {"tile", tile, 768, 768, 1.5F, 0.30F, 60.0F},
    {"zinc", zinc, 256, 256, 0.4F, 0.25F, 30.0F},
    {"wood", wood, 384, 384, 1.0F, 0.04F, 14.0F},
    {"dial", dial, 256, 256, 1.0F, 0.20F, 60.0F},
    {"dark", dark, 8, 8, 1.0F, 0.0F, 8.0F},
}};

}  // namespace

std::span<const Finish> finishes() { return kFinishes; }

}  // namespace obscura::stimuli::machine
