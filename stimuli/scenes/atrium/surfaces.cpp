// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "stimuli/scenes/atrium/parts.h"
#include "stimuli/scenes/support/assembly.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;

/// The noise that the textures share: 8 x 8 cells, read at whole multiples of uv and free offsets.
float noise(vec2 uv) {
    static const NoiseTile tile(31, 8, 5);
    return tile.at(uv);
}

/// Where a point lies in a wall of blocks: distance to the block's nearest edge, and its id.
struct Masonry {
    float edge_m = 0.0F;
    std::uint32_t id = 0;
};

/// Courses of `size_m` / `counts` blocks with shifted, jittered joints; wraps over size_m.
Masonry masonry(vec2 uv, vec2 size_m, glm::ivec2 counts, float jitter, std::uint32_t seed) {
    const float course_m = size_m.y / static_cast<float>(counts.y);
    const float block_m = size_m.x / static_cast<float>(counts.x);
    const auto joint_y = [&](int row) {
        const int wrapped = (row % counts.y + counts.y) % counts.y;
        return course_m *
               (static_cast<float>(row) + 0.5F * jitter * (hash_unit(wrapped, 7, 1, seed) - 0.5F));
    };
    const float y = uv.y * size_m.y;
    int row = static_cast<int>(std::floor(y / course_m));
    if (y < joint_y(row)) --row;
    if (y >= joint_y(row + 1)) ++row;
    const int wrapped_row = (row % counts.y + counts.y) % counts.y;
    const float shift =
        0.5F * static_cast<float>(row & 1) + 0.3F * hash_unit(wrapped_row, 3, 2, seed);
    const auto joint_x = [&](int column) {
        const int wrapped = (column % counts.x + counts.x) % counts.x;
        return block_m * (static_cast<float>(column) + shift +
                          jitter * (hash_unit(wrapped, wrapped_row, 3, seed) - 0.5F));
    };
    const float x = uv.x * size_m.x;
    int column = static_cast<int>(std::floor(x / block_m - shift));
    if (x < joint_x(column)) --column;
    if (x >= joint_x(column + 1)) ++column;
    Masonry found;
    found.edge_m = std::min(std::min(x - joint_x(column), joint_x(column + 1) - x),
                            std::min(y - joint_y(row), joint_y(row + 1) - y));
    found.id = hash_lattice((column % counts.x + counts.x) % counts.x, wrapped_row, 4, seed);
    return found;
}

float unit_of(std::uint32_t id, int which) {
    return hash_unit(static_cast<int>(id & 0xffffU), static_cast<int>(id >> 16), which, 77);
}

/// Weathered limestone: mottled, finely pitted where it is weakest.
Texel limestone(vec2 uv, vec2 offset) {
    const float broad = noise(uv + offset);
    const float fine = noise(uv * 9.0F + offset.y);
    const float grains = noise(uv * 17.0F + offset.x);
    const float hole =
        glm::smoothstep(0.0F, 0.5F, broad + 0.3F * fine) * glm::smoothstep(0.28F, 0.42F, grains);
    Texel texel;
    texel.albedo = glm::mix(colour<0x9c8c72>(), colour<0xc4b595>(),
                            glm::clamp(0.5F + 0.9F * broad, 0.0F, 1.0F));
    texel.albedo *= (1.0F + 0.16F * fine) * (1.0F - 0.35F * hole);
    texel.height_m = 0.0016F * broad + 0.0011F * fine - 0.0022F * hole;
    texel.roughness = 0.60F + 0.12F * fine + 0.30F * hole - 0.10F * broad;
    return texel;
}

Texel ashlar(vec2 uv) {
    const vec2 size_m(3.2F);
    const vec2 wobble(noise(uv * 2.0F), noise(uv * 2.0F + 0.37F));
    const Masonry block = masonry(uv + 0.0022F * wobble, size_m, {5, 9}, 0.34F, 21);
    const float tone = unit_of(block.id, 0);
    const float warmth = unit_of(block.id, 1);
    const float chipped =
        std::max(0.0F, noise(uv * 4.0F + 0.71F) - 0.1F) * 0.05F * unit_of(block.id, 2);
    const float edge = block.edge_m - chipped;
    const float inside = glm::smoothstep(0.004F, 0.018F, edge);
    Texel texel = limestone(uv, vec2(unit_of(block.id, 3), unit_of(block.id, 4)));
    texel.albedo *= (0.66F + 0.48F * tone) *
                    glm::mix(vec3(1.03F, 0.99F, 0.92F), vec3(0.98F, 1.0F, 1.03F), warmth);
    texel.albedo *= 0.80F + 0.20F * glm::smoothstep(0.008F, 0.06F, edge);
    const vec3 mortar = colour<0x6f6555>() * (1.0F + 0.25F * wobble.x);
    texel.albedo = glm::mix(mortar, texel.albedo, inside);
    texel.roughness = glm::mix(0.90F, texel.roughness + 0.12F * (tone - 0.5F), inside);
    const float pillow = glm::smoothstep(0.0F, 0.045F, edge);
    texel.height_m = glm::mix(
        -0.007F, texel.height_m * 1.6F + 0.003F * pillow + 0.003F * (unit_of(block.id, 5) - 0.5F),
        inside);
    return texel;
}

Texel brickwork(vec2 uv, vec2 size_m, glm::ivec2 counts) {
    const Masonry brick = masonry(uv, size_m, counts, 0.06F, 91);
    const float inside = glm::smoothstep(0.005F, 0.011F, brick.edge_m);
    const float tone = unit_of(brick.id, 0);
    const float grit = noise(uv * vec2(8.0F, 4.0F) + 0.13F);
    vec3 clay = glm::mix(colour<0x8f5a41>(), colour<0xb98263>(), tone);
    clay = glm::mix(clay, colour<0x7a5546>(), unit_of(brick.id, 1) > 0.8F ? 0.7F : 0.0F);
    Texel texel;
    texel.albedo = glm::mix(colour<0xa89a86>(), clay, inside) * (1.0F + 0.22F * grit);
    texel.height_m = -0.016F + inside * (0.006F + 0.0015F * grit);
    texel.roughness = glm::mix(0.92F, 0.70F + 0.15F * grit, inside);
    return texel;
}

/// Old lime plaster, fallen off in places so that the brick shows. Covers 8 m x 4 m.
Texel plaster(vec2 uv) {
    const vec2 size_m(8.0F, 4.0F);
    const glm::ivec2 period(8, 4);
    const vec2 p = uv * vec2(period);
    const float broad = fbm(p * 0.5F + 0.25F, 51, 2, {4, 2});
    const float medium = noise(uv * vec2(4.0F, 2.0F));
    const float fine = noise(uv * vec2(26.0F, 13.0F) + 0.3F);
    const float loss = fbm(p, 54, 4, period) + 0.06F * medium + 0.35F * broad - 0.40F;
    const float gone = glm::smoothstep(-0.004F, 0.012F, loss);
    const float lip = glm::smoothstep(-0.05F, 0.0F, loss) * (1.0F - gone);
    const CellularNoise crack_cell = cellular(p * 1.5F + 0.25F * medium, 55, {12, 6});
    const float crack =
        (1.0F - glm::smoothstep(0.0F, 0.012F, crack_cell.second - crack_cell.nearest)) *
        glm::smoothstep(-0.1F, 0.25F, broad + 0.5F * medium);
    Texel texel;
    texel.albedo = glm::mix(colour<0xb08f69>(), colour<0xcdb48f>(),
                            glm::clamp(0.5F + 0.7F * broad + 0.35F * medium, 0.0F, 1.0F));
    const float repaired = glm::smoothstep(0.18F, 0.2F, noise(uv + 0.61F));
    texel.albedo = glm::mix(texel.albedo, colour<0xcbb89b>(), 0.6F * repaired);
    texel.albedo *= 1.0F + 0.06F * fine - 0.35F * crack + 0.12F * lip;
    texel.height_m = 0.003F * medium + 0.0006F * fine - 0.002F * crack + 0.001F * repaired;
    texel.roughness = 0.72F + 0.12F * medium + 0.08F * fine - 0.06F * repaired;
    if (gone <= 0.0F) return texel;
    const Texel brick = brickwork(uv, size_m, {32, 52});
    texel.albedo = glm::mix(texel.albedo, brick.albedo, gone);
    texel.height_m = glm::mix(texel.height_m, brick.height_m, gone);
    texel.roughness = glm::mix(texel.roughness, brick.roughness, gone);
    return texel;
}

/// 4 x 4 floor tiles, each to its edge; the joint is half on either side.
Texel floor_tiles(vec2 uv) {
    const vec2 cell = uv * 4.0F;
    const vec2 in_cell = glm::fract(cell);
    const vec2 to_edge = glm::min(in_cell, 1.0F - in_cell) * 0.6F;
    const glm::ivec2 tile(cell);
    const std::uint32_t id = hash_lattice(tile.x, tile.y, 0, 61);
    const float chips = std::max(0.0F, noise(uv * 8.0F + 0.2F) - 0.15F) * 0.03F;
    const float edge = std::min(to_edge.x, to_edge.y) - chips;
    const float corner = to_edge.x + to_edge.y - 0.05F * (unit_of(id, 1) > 0.7F ? 1.0F : 0.0F);
    const float inside = glm::smoothstep(0.003F, 0.009F, std::min(edge, corner));
    // Each tile was sawn from another place in the stone.
    const vec2 place = uv + vec2(unit_of(id, 2), unit_of(id, 3));
    const float broad = noise(place);
    const float vein = glm::smoothstep(0.05F, 0.0F, std::abs(noise(vec2(place.y, place.x) + 0.4F)));
    const float fine = noise(uv * 14.0F);
    const float scratch = glm::smoothstep(0.3F, 0.6F, noise(uv * vec2(2.0F, 12.0F) + place.x));
    Texel texel;
    texel.albedo =
        glm::mix(colour<0x8d7d66>(), colour<0xbaa98b>(), glm::clamp(0.5F + broad, 0.0F, 1.0F));
    texel.albedo *= (0.86F + 0.24F * unit_of(id, 0)) * (1.0F + 0.08F * fine - 0.08F * scratch);
    texel.albedo *= 1.0F - 0.18F * vein;
    texel.albedo = glm::mix(colour<0x6f6455>(), texel.albedo, inside);
    texel.height_m = glm::mix(-0.006F, 0.0012F * broad + 0.0004F * fine, inside);
    // Trodden smooth where no scratch is, dusty in the joints.
    const float trodden = glm::smoothstep(-0.3F, 0.3F, noise(uv * 2.0F + 0.83F));
    texel.roughness = glm::mix(
        0.90F, 0.56F - 0.14F * trodden + 0.16F * scratch + 0.06F * fine - 0.05F * vein, inside);
    return texel;
}

/// Old oak, the grain along v. Covers 1 m.
Texel wood(vec2 uv) {
    const float bend = fbm(uv * vec2(4.0F, 2.0F), 81, 3, {4, 2});
    const vec2 p(uv.x + 0.012F * bend, uv.y);
    const float grain = fbm(p * vec2(48.0F, 3.0F), 82, 4, {48, 3});
    const float fibre = fbm(p * vec2(160.0F, 6.0F), 83, 2, {160, 6});
    const float split = glm::smoothstep(0.38F, 0.5F, fbm(p * vec2(20.0F, 2.0F), 84, 3, {20, 2}));
    Texel texel;
    texel.albedo = glm::mix(colour<0x4d3521>(), colour<0x8a6845>(),
                            glm::clamp(0.5F + 0.9F * grain, 0.0F, 1.0F));
    texel.albedo *= (1.0F + 0.2F * fibre + 0.2F * bend) * (1.0F - 0.6F * split);
    texel.height_m = 0.0012F * grain + 0.0006F * fibre - 0.004F * split;
    texel.roughness = 0.58F - 0.14F * grain + 0.3F * split;
    return texel;
}

Texel clay(vec2 uv) {
    const float broad = noise(uv);
    const float fine = noise(uv * 8.0F);
    const float lichen = glm::smoothstep(0.2F, 0.35F, noise(uv * 2.0F + 0.5F));
    Texel texel;
    texel.albedo =
        glm::mix(colour<0x74432f>(), colour<0xa2684a>(), glm::clamp(0.5F + broad, 0.0F, 1.0F));
    texel.albedo = glm::mix(texel.albedo, colour<0x9a8e74>(), 0.55F * lichen);
    texel.albedo *= 1.0F + 0.15F * fine;
    texel.height_m = 0.001F * broad + 0.0008F * fine;
    texel.roughness = 0.62F + 0.10F * fine + 0.25F * lichen;
    return texel;
}

/// Heavy woven cloth; near white, for the parts' tint to dye.
Texel cloth(vec2 uv) {
    const vec2 thread = uv * 120.0F * 6.2831853F;
    const float weave = 0.5F + 0.5F * std::sin(thread.x) * std::sin(thread.y);
    const float faded = noise(uv);
    const float slub = noise(uv * vec2(12.0F, 1.0F));
    Texel texel;
    texel.albedo = vec3(0.80F + 0.2F * faded + 0.08F * slub) * (0.88F + 0.12F * weave);
    texel.height_m = 0.0005F * weave + 0.0004F * slub;
    return texel;
}

/// Distance inside (positive) the figure of a banner, of its width: a ring around a star of eight.
float emblem(vec2 q) {
    const float r = glm::length(q);
    const float star = 0.215F + 0.085F * std::cos(8.0F * std::atan2(q.x, q.y));
    return std::max(std::max(0.022F - std::abs(r - 0.375F), 0.008F - std::abs(r - 0.335F)),
                    std::min(star - r, r - 0.07F));
}

/// Banners of 1.05 m x 3 m: red, green and blue, with borders and a figure in gold thread.
Texel banner(vec2 uv) {
    const int which = std::min(2, static_cast<int>(uv.x * 3.0F));
    const vec2 place(uv.x * 3.0F - static_cast<float>(which), uv.y * (3.0F / 1.05F));
    const float edge = std::min(place.x, 1.0F - place.x);
    const float below = 3.0F / 1.05F - place.y;
    const float frame = 0.016F - std::min(std::abs(edge - 0.085F),
                                          std::abs(below - 0.12F) + (edge < 0.085F ? 1.0F : 0.0F));
    const float lower = below > 0.1F ? frame : -1.0F;
    const float tooth = std::abs(glm::fract(place.x * 9.0F) - 0.5F) * 0.09F;
    const float hem = 0.045F + tooth - below;
    const float sign = std::max(std::max(lower, hem), emblem(place - vec2(0.5F, 2.16F)));
    const float gold = glm::smoothstep(-0.003F, 0.003F, sign);
    Texel texel = cloth(vec2(uv.x * 3.0F, uv.y * 3.0F));
    const vec3 dye = which == 0 ? kDyeRed : (which == 1 ? kDyeGreen : kDyeBlue);
    texel.albedo *= glm::mix(dye, kDyeGold, gold);
    texel.height_m += 0.0012F * gold;
    return texel;
}

/// How far inside a leaf's outline a point lies, negative outside; v runs from stalk to tip.
float inside_leaf(int kind, vec2 p) {
    const float across = std::abs(p.x - 0.5F) * 2.0F;
    if (kind == 0) {
        // A palm's spray: narrow leaflets that point outwards and up along a stem.
        constexpr float kLeaflets = 22.0F;
        const float stem = 0.05F * (1.05F - p.y) - across;
        const float length =
            0.96F * std::pow(std::sin(3.0F * std::pow(0.03F + 0.96F * p.y, 0.7F)), 0.7F);
        const float along = p.y * kLeaflets - 2.6F * across + (p.x > 0.5F ? 0.5F : 0.0F);
        const float middle = std::abs(along - std::floor(along) - 0.5F);
        const float leaflet = 0.40F * std::sqrt(std::max(0.0F, 1.0F - across / length)) - middle;
        return std::max(stem, p.y > 0.06F && across < length ? 0.5F * leaflet : -1.0F);
    }
    const float shape = std::sin(3.1415927F * std::pow(0.02F + 0.97F * p.y, 0.75F));
    if (kind == 1) return 0.94F * shape * (1.0F + 0.03F * std::sin(70.0F * p.y)) - across;
    // Three lobes on either side.
    const float lobes = 0.80F + 0.20F * std::cos(3.0F * 6.2831853F * (p.y + 0.22F * across) - 1.0F);
    return 0.96F * std::pow(shape, 0.8F) * lobes - across;
}

/// A palm's spray, an oval and a lobed leaf side by side, cut out.
Texel leaf(vec2 uv) {
    const int kind = std::min(2, static_cast<int>(uv.x * 3.0F));
    const vec2 p(uv.x * 3.0F - static_cast<float>(kind), uv.y);
    const float across = std::abs(p.x - 0.5F) * 2.0F;
    const float middle = 1.0F - glm::smoothstep(0.0F, 0.09F, across);
    const float ribs = std::abs(glm::fract(p.y * 7.0F + 0.9F * across) - 0.5F) * 2.0F;
    const float rib = (1.0F - glm::smoothstep(0.0F, 0.16F, ribs)) * (1.0F - across);
    const float mottle = noise(uv);
    Texel texel;
    texel.albedo = glm::mix(colour<0x3d5a26>(), colour<0x6d8a41>(),
                            glm::clamp(0.45F + 0.6F * mottle, 0.0F, 1.0F));
    texel.albedo = glm::mix(texel.albedo, colour<0x9aa765>(), 0.6F * middle + 0.25F * rib);
    texel.height_m = 0.0006F * middle + 0.0003F * rib + 0.0003F * mottle;
    texel.opacity = glm::clamp(0.5F + 10.0F * inside_leaf(kind, p), 0.0F, 1.0F);
    return texel;
}

Texel soil(vec2 uv) {
    const CellularNoise clod = cellular(uv * 24.0F, 131, {24, 24});
    const float fine = noise(uv * 8.0F);
    Texel texel;
    texel.albedo = colour<0x43342a>() * (0.8F + 0.5F * unit_of(clod.id, 0) + 0.3F * fine);
    texel.height_m = -0.006F * clod.nearest + 0.001F * fine;
    return texel;
}

Texel iron(vec2 uv) {
    const float rust = noise(uv * 2.0F);
    Texel texel;
    texel.albedo =
        glm::mix(colour<0x2c2a29>(), colour<0x5a4030>(), glm::smoothstep(0.0F, 0.5F, rust));
    texel.height_m = 0.0006F * rust;
    texel.roughness = 0.46F + 0.40F * glm::smoothstep(0.0F, 0.5F, rust);
    return texel;
}

Texel stone(vec2 uv) { return limestone(uv, vec2(0.0F)); }
Texel lamp_glass(vec2 uv) {
    Texel texel;
    texel.albedo = colour<0xd9c79a>() * (1.0F + 0.15F * fbm(uv * 4.0F, 151, 3, {4, 4}));
    return texel;
}

}  // namespace

std::array<vec2, kSurfaces> add_surfaces(renderer::Scene& scene) {
    const std::array<Finish, kSurfaces> finishes{{
        {"ashlar", ashlar, 1024, 1024, 3.2F, 0.04F, kBaked},
        {"stone", stone, 768, 768, 1.8F, 0.06F, kBaked},
        {"plaster", plaster, 1536, 768, 8.0F, 0.02F, kBaked},
        {"floor", floor_tiles, 1024, 1024, 2.4F, 0.10F, kBaked},
        {"wood", wood, 512, 512, 1.0F, 0.05F, kBaked},
        {"roof", clay, 512, 512, 1.0F, 0.04F, kBaked, true},
        {"cloth", cloth, 512, 512, 1.0F, 0.02F, 8.0F, true},
        {"banner", banner, 768, 768, 3.15F, 0.02F, 8.0F, true},
        {"leaf", leaf, 768, 512, 1.0F, 0.10F, 24.0F, true, true},
        {"soil", soil, 256, 256, 0.8F, 0.0F, 8.0F},
        {"iron", iron, 256, 256, 0.5F, 0.25F, kBaked},
        {"lamp-glass", lamp_glass, 64, 64, 0.3F, 0.4F, 64.0F},
    }};
    std::array<vec2, kSurfaces> size_m{};
    for (std::size_t i = 0; i < kSurfaces; ++i) size_m[i] = add_finish(scene, finishes[i]);
    return size_m;
}

}  // namespace obscura::stimuli::atrium
