// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/room/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::room {
namespace {

using glm::vec2;
using glm::vec3;

float noise(vec2 uv) { return shared_noise(uv); }

/// Emulsion over plaster, rolled on, a little soiled. Covers 3 m.
Texel wall(vec2 uv) {
    const float broad = noise(uv);
    const float stipple = noise(uv * 37.0F);
    const float trowel = noise(uv * 4.0F + 0.3F);
    Texel texel;
    texel.albedo = colour<0xcfc9b4>() * (1.0F + 0.05F * broad + 0.03F * trowel + 0.04F * stipple);
    texel.height_m = 0.0010F * trowel + 0.0003F * stipple;
    return texel;
}

/// Boards 0.16 m wide and 1.6 m long along u, with bevelled edges. Covers 3.2 m x 1.6 m.
Texel boards(vec2 uv) {
    const int row = static_cast<int>(uv.y * 10.0F);
    const float across = uv.y * 10.0F - static_cast<float>(row);
    const float shift = hash_unit(row, 0, 0, 14);
    const float along = uv.x * 2.0F + shift;
    const int column = static_cast<int>(along) % 2;
    const float in_board = along - std::floor(along);
    const float own = hash_unit(row, column, 1, 14);
    const float edge_m = std::min(std::min(across, 1.0F - across) * 0.16F,
                                  std::min(in_board, 1.0F - in_board) * 1.6F);
    const float bend = noise(uv + vec2(own, 0.0F));
    const vec2 place(uv.x + own, uv.y + 0.004F * bend);
    const float grain = fbm(place * vec2(8.0F, 280.0F), 83, 2, {8, 280});
    const float figure = noise(place * vec2(2.0F, 19.0F) + own);
    const float gap = 1.0F - glm::smoothstep(0.0006F, 0.0022F, edge_m);
    const float worn = glm::smoothstep(-0.2F, 0.4F, noise(uv + 0.37F));
    Texel texel;
    texel.albedo = glm::mix(colour<0x8a6d4d>(), colour<0xba9970>(),
                            glm::clamp(0.5F + 0.5F * grain + 0.5F * figure, 0.0F, 1.0F));
    texel.albedo *= 0.72F + 0.36F * own;
    texel.albedo = glm::mix(texel.albedo, colour<0xa68a68>(), 0.35F * worn);
    texel.albedo *= 1.0F - 0.8F * gap;
    texel.height_m = 0.0002F * grain - 0.0015F * gap;
    texel.roughness = 0.44F + 0.05F * grain + 0.18F * worn + 0.3F * gap;
    return texel;
}

/// Oiled walnut, grain along v. Covers 0.4 m x 1.2 m.
Texel wood(vec2 uv) {
    const float bend = noise(uv);
    const float figure = noise(vec2(uv.x * 7.0F + 0.2F * bend, uv.y) + 0.4F);
    const float grain = fbm(vec2(uv.x + 0.014F * bend, uv.y) * vec2(90.0F, 4.0F), 82, 3, {90, 4});
    Texel texel;
    texel.albedo = glm::mix(colour<0x4a2f1e>(), colour<0x7d5636>(),
                            glm::clamp(0.5F + 0.45F * grain + 0.8F * figure, 0.0F, 1.0F));
    texel.albedo *= 1.0F + 0.15F * bend;
    texel.height_m = 0.00006F * grain;
    texel.roughness = 0.49F + 0.08F * grain + 0.10F * figure;
    return texel;
}

Texel lacquer(vec2 uv) {
    const float brush = noise(uv * vec2(2.0F, 23.0F));
    const float soil = glm::smoothstep(0.1F, 0.6F, noise(uv * 2.0F));
    Texel texel;
    texel.albedo = colour<0xdedad0>() * (1.0F + 0.03F * brush - 0.08F * soil);
    texel.height_m = 0.0001F * brush;
    texel.roughness = 0.45F + 0.05F * brush + 0.20F * soil;
    return texel;
}

/// Edges of pages: fine lines along u.
Texel paper(vec2 uv) {
    const float leaf = noise(vec2(uv.x, uv.y * 61.0F));
    const float age = noise(uv * 3.0F);
    Texel texel;
    texel.albedo = colour<0xe2d9c2>() * (0.93F + 0.13F * leaf + 0.07F * age);
    texel.height_m = 0.0001F * leaf;
    return texel;
}

/// A page of text: a heading, paragraphs of ragged lines and a figure.
Texel print(vec2 uv) {
    Texel texel;
    texel.albedo = colour<0xe9e6dc>() * (1.0F + 0.02F * noise(uv));
    const vec2 margin(0.12F, 0.09F);
    if (uv.x < margin.x || uv.x > 1.0F - margin.x || uv.y < margin.y || uv.y > 1.0F - margin.y) {
        return texel;
    }
    const float line = (uv.y - margin.y) * 62.0F;
    const int row = static_cast<int>(line);
    const float in_line = line - static_cast<float>(row);
    const bool figure = row >= 24 && row < 35;
    if (figure) {
        const vec2 p(uv.x, (line - 24.0F) / 11.0F);
        const float curve = 0.5F + 0.35F * std::sin(9.0F * p.x) * std::exp(-2.0F * (p.x - 0.2F));
        const bool frame = p.x < 0.135F || p.x > 0.865F || p.y < 0.03F || p.y > 0.97F;
        if (frame || std::abs(p.y - curve) < 0.03F) texel.albedo = vec3(0.12F);
        return texel;
    }
    const float end = row % 7 == 6 ? 0.25F + 0.5F * hash_unit(row, 0, 0, 3) : 1.0F - margin.x;
    if (row == 1 || row % 7 == 0 || uv.x > end) return texel;
    const float letters = hash_unit(static_cast<int>(uv.x * 150.0F), row, 1, 3);
    if (in_line > 0.25F && in_line < 0.72F && letters > 0.22F) {
        texel.albedo = vec3(0.16F + 0.25F * letters);
    }
    return texel;
}

Texel binding(vec2 uv) {
    const vec2 thread = uv * 110.0F * glm::two_pi<float>();
    const float weave = 0.5F + 0.5F * std::sin(thread.x) * std::sin(thread.y);
    const float rubbed = noise(uv * 2.0F);
    Texel texel;
    texel.albedo = vec3(0.86F + 0.10F * weave + 0.16F * rubbed);
    texel.height_m = 0.00012F * weave;
    return texel;
}

Texel curtain(vec2 uv) {
    const vec2 thread = uv * 150.0F * glm::two_pi<float>();
    const float weave = 0.5F + 0.5F * std::sin(thread.x) * std::sin(thread.y);
    const float stripe = glm::smoothstep(0.46F, 0.5F, std::abs(glm::fract(uv.x * 6.0F) - 0.5F));
    Texel texel;
    texel.albedo = glm::mix(colour<0x8f9a94>(), colour<0xc9c3ae>(), stripe) *
                   (0.88F + 0.12F * weave + 0.06F * noise(uv));
    texel.height_m = 0.0003F * weave;
    return texel;
}

Texel upholstery(vec2 uv) {
    const vec2 thread = uv * 64.0F * glm::two_pi<float>();
    const float rib = 0.5F + 0.5F * std::sin(thread.x + 0.6F * std::sin(thread.y));
    const float worn = noise(uv);
    Texel texel;
    texel.albedo = colour<0x5d3b34>() * (0.80F + 0.25F * rib + 0.25F * worn);
    texel.height_m = 0.0005F * rib;
    return texel;
}

/// A woven rug with borders and a field of diamonds, knots 4 mm apart.
Texel rug(vec2 uv) {
    const vec2 knots(520.0F, 340.0F);
    const vec2 cell = glm::floor(uv * knots) / knots;
    const vec2 in = glm::fract(uv * knots);
    const float edge =
        std::min(std::min(cell.x, 1.0F - cell.x) * 1.53F, std::min(cell.y, 1.0F - cell.y));
    const vec2 q(cell.x * 14.0F, cell.y * 9.0F);
    const vec2 f = glm::abs(glm::fract(q) - 0.5F);
    const float diamond = f.x + f.y;
    const int kind = (static_cast<int>(q.x) + 2 * static_cast<int>(q.y)) % 3;
    vec3 field = diamond < 0.13F   ? colour<0xc9a86a>()
                 : diamond < 0.30F ? (kind == 0 ? colour<0x2d4456>() : colour<0x6c7550>())
                 : diamond < 0.36F ? colour<0xd0bf98>()
                                   : colour<0x7d2f28>();
    const float key = glm::fract((cell.x * 1.53F + cell.y) * 24.0F);
    if (edge < 0.14F) field = key < 0.5F ? colour<0x2b3a4b>() : colour<0x80332b>();
    if (std::abs(edge - 0.14F) < 0.008F || std::abs(edge - 0.05F) < 0.008F) {
        field = colour<0xd0bf98>();
    }
    if (edge < 0.042F) field = colour<0x6f2a26>();
    const float own =
        hash_unit(static_cast<int>(cell.x * knots.x), static_cast<int>(cell.y * knots.y), 0, 9);
    const float knot =
        (1.0F - 2.0F * std::abs(in.x - 0.5F)) * (1.0F - 2.0F * std::abs(in.y - 0.5F));
    const float worn = glm::smoothstep(0.0F, 0.5F, noise(uv + 0.2F));
    Texel texel;
    texel.albedo =
        glm::mix(field, colour<0x9c8d78>(), 0.25F * worn) * (0.72F + 0.3F * own + 0.16F * knot);
    texel.height_m = 0.0012F * knot + 0.0005F * own;
    return texel;
}

Texel metal(vec2 uv) {
    Texel texel;
    texel.albedo = colour<0x9d9c98>() * (1.0F + 0.12F * noise(uv * vec2(1.0F, 17.0F)));
    texel.height_m = 0.0F;
    return texel;
}

Texel plastic(vec2 uv) {
    Texel texel;
    texel.albedo = vec3(0.92F + 0.06F * noise(uv * 9.0F));
    texel.height_m = 0.00006F * noise(uv * 19.0F);
    return texel;
}

Texel ceramic(vec2 uv) {
    Texel texel;
    texel.albedo = vec3(0.88F + 0.05F * noise(uv));
    texel.height_m = 0.0001F * noise(uv * 3.0F);
    return texel;
}

/// A broad leaf with a point, v from the stalk to the tip.
Texel leaf(vec2 uv) {
    const float across = std::abs(uv.x - 0.5F) * 2.0F;
    const float t = glm::clamp(uv.y, 0.0F, 1.0F);
    const float half = 0.96F * std::pow(std::sin(glm::pi<float>() * std::pow(t, 0.72F)), 0.8F) *
                       (1.0F + 0.03F * std::sin(40.0F * t));
    const float middle = 1.0F - glm::smoothstep(0.0F, 0.05F, across);
    const float ribs = std::abs(glm::fract(t * 9.0F - 1.3F * across) - 0.5F) * 2.0F;
    const float rib = 1.0F - glm::smoothstep(0.0F, 0.18F, ribs);
    Texel texel;
    texel.albedo = glm::mix(colour<0x2f5326>(), colour<0x547a38>(),
                            glm::clamp(0.5F + 0.6F * noise(uv), 0.0F, 1.0F));
    texel.albedo = glm::mix(texel.albedo, colour<0x9db068>(), 0.7F * middle + 0.22F * rib);
    texel.height_m = 0.0010F * middle + 0.0006F * rib;
    texel.opacity = glm::clamp(0.5F + 12.0F * (half - across), 0.0F, 1.0F);
    return texel;
}

Texel soil(vec2 uv) {
    const CellularNoise clod = cellular(uv * 20.0F, 131, {20, 20});
    Texel texel;
    texel.albedo = colour<0x3c2e24>() *
                   (0.8F + 0.5F * hash_unit(static_cast<int>(clod.id & 0xffffU), 0, 0, 2));
    texel.height_m = -0.006F * clod.nearest;
    return texel;
}

/// Side by side: hills under a sky, a still life of two pears, a sail at dusk.
Texel picture(vec2 uv) {
    const int subject = static_cast<int>(uv.x * 3.0F);
    const vec2 p(glm::fract(uv.x * 3.0F), uv.y);
    const float stroke = noise(uv * vec2(21.0F, 9.0F));
    Texel texel;
    if (subject == 0) {
        const float far = 0.48F + 0.07F * std::sin(6.0F * p.x) + 0.03F * std::sin(17.0F * p.x);
        const float near = 0.66F + 0.09F * std::sin(4.0F * p.x + 2.0F);
        texel.albedo = glm::mix(colour<0x8fb0c4>(), colour<0xe0cfae>(), p.y * 1.9F);
        if (p.y > far) texel.albedo = colour<0x6f8797>();
        if (p.y > near) texel.albedo = glm::mix(colour<0x5e7440>(), colour<0x39482c>(), p.y);
    } else if (subject == 2) {
        const float wave = noise(vec2(3.0F * uv.x, 25.0F * uv.y));
        texel.albedo = glm::mix(colour<0x4d5f7a>(), colour<0xd9a06a>(), 1.5F * p.y);
        if (glm::length(vec2(1.3F, 1.0F) * (p - vec2(0.68F, 0.50F))) < 0.07F)
            texel.albedo = colour<0xe8c98a>();
        if (p.y > 0.62F)
            texel.albedo = glm::mix(colour<0x8d7a6c>(), colour<0x2c3d4e>(), 3.2F * (p.y - 0.62F)) *
                           (1.0F + 0.35F * wave);
        const float sail = p.y - 0.34F;
        if (sail > 0.0F && p.y < 0.66F && p.x < 0.40F && p.x > 0.40F - 0.62F * sail)
            texel.albedo = colour<0xcbb89a>();
        if (p.y >= 0.67F && p.y < 0.71F && std::abs(p.x - 0.36F) < 0.15F - 1.2F * (p.y - 0.67F))
            texel.albedo = colour<0x3b2b22>();
    } else {
        texel.albedo = glm::mix(colour<0x4b4238>(), colour<0x7b6a55>(), p.x);
        if (p.y > 0.68F) texel.albedo = colour<0x8d7354>();
        for (const float x : {0.38F, 0.62F}) {
            const vec2 q = (p - vec2(x, 0.6F)) / vec2(0.13F, 0.19F);
            const float waist = 1.0F - 0.45F * glm::smoothstep(0.2F, -1.0F, q.y);
            const float r = glm::length(vec2(q.x / waist, q.y));
            if (r < 1.0F)
                texel.albedo = glm::mix(colour<0xc9b24e>(), colour<0x6f5a22>(),
                                        glm::clamp(r * 0.6F + q.x * 0.5F, 0.0F, 1.0F));
        }
    }
    texel.albedo *= 1.0F + 0.18F * stroke;
    texel.height_m = 0.0004F * stroke;
    return texel;
}

Texel bulb(vec2) {
    Texel texel;
    texel.albedo = vec3(1.0F);
    return texel;
}

constexpr std::array<Finish, 17> kFinishes{{
    {"wall", wall, 768, 768, 3.0F, 0.02F, 10.0F},
    {"floor-boards", boards, 1024, 512, 3.2F, 0.16F, kBaked},
    {"wood", wood, 512, 1536, 0.4F, 0.12F, kBaked},
    {"lacquer", lacquer, 256, 256, 0.8F, 0.20F, kBaked},
    {"paper", paper, 256, 256, 0.12F, 0.01F, 8.0F, true},
    {"print", print, 384, 512, 1.0F, 0.02F, 8.0F, true},
    {"binding", binding, 384, 384, 0.4F, 0.05F, 14.0F, true},
    {"curtain", curtain, 512, 512, 0.6F, 0.02F, 8.0F, true},
    {"upholstery", upholstery, 512, 512, 0.4F, 0.03F, 10.0F},
    {"rug", rug, 1040, 680, 1.0F, 0.01F, 8.0F},
    {"metal", metal, 128, 128, 0.2F, 0.5F, 60.0F},
    {"plastic", plastic, 128, 128, 0.2F, 0.12F, 24.0F},
    {"ceramic", ceramic, 128, 128, 0.2F, 0.35F, 70.0F},
    {"leaf", leaf, 256, 256, 1.0F, 0.15F, 30.0F, true, true},
    {"soil", soil, 128, 128, 0.3F, 0.0F, 8.0F},
    {"picture", picture, 768, 256, 1.0F, 0.06F, 20.0F},
    {"bulb", bulb, 8, 8, 1.0F, 0.0F, 8.0F, false, false, vec3(6.0F, 4.4F, 2.6F)},
}};

}  // namespace

std::span<const Finish> finishes() { return kFinishes; }

}  // namespace obscura::stimuli::room
