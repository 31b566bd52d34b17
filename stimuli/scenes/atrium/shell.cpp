// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/atrium/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;
using renderer::Vertex;

/// One tile of a floor: a random cell of the texture, turned at random, with its own shade.
void put_tile(Site& site, vec3 corner, vec2 size_m, std::uint32_t seed, const vec3& tint) {
    Mesh tile = rectangle(corner, {0.0F, 0.0F, size_m.y}, {size_m.x, 0.0F, 0.0F}, 0.31F);
    const int cell = static_cast<int>(hash_lattice(static_cast<int>(seed), 0, 0, 17) & 15U);
    const int turns = static_cast<int>(hash_lattice(static_cast<int>(seed), 1, 0, 17) & 3U);
    for (Vertex& vertex : tile.vertices) {
        vec2 in_tile(vertex.uv.x / size_m.y, -vertex.uv.y / size_m.x);
        for (int i = 0; i < turns; ++i) in_tile = {1.0F - in_tile.y, in_tile.x};
        vertex.uv = (vec2(cell & 3, cell >> 2) + in_tile) * 0.25F;
    }
    make_tangents(tile);
    site.put_mapped(Surface::kFloor, tile, glm::mat4(1.0F), tint * shade(seed, 0.22F));
}

/// Rows of tiles over [x0, x1] x [-kHalfLength, kHalfLength] at height y, tiles `across` wide.
void put_floor(Site& site, float x0, float x1, float y, int across, std::uint32_t seed,
               const vec3& light, const vec3& dark) {
    const float width = (x1 - x0) / static_cast<float>(across);
    const int rows = static_cast<int>(std::round(2.0F * kHalfLength / width));
    const float depth = 2.0F * kHalfLength / static_cast<float>(rows);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < across; ++i) {
            const vec3 corner(x0 + width * static_cast<float>(i), y,
                              -kHalfLength + depth * static_cast<float>(j));
            const auto own = seed + static_cast<std::uint32_t>(j * across + i);
            put_tile(site, corner, {width, depth}, own, ((i + j) & 1) != 0 ? light : dark);
        }
    }
}

void build_floors(Site& site) {
    const vec3 light(1.0F);
    const vec3 dark(0.86F, 0.80F, 0.75F);
    const vec3 border(0.72F, 0.64F, 0.58F);
    put_floor(site, -2.7F, 2.7F, 0.0F, 9, 10000U, light, dark);
    for (const float side : {-1.0F, 1.0F}) {
        // A band of darker slabs under the arcade, then the aisle.
        const float inner = side > 0.0F ? 2.7F : -3.3F;
        put_floor(site, inner, inner + 0.6F, 0.0F, 1, side > 0.0F ? 20000U : 21000U, border,
                  border);
        const float under = side > 0.0F ? 3.3F : -3.9F;
        put_floor(site, under, under + 0.6F, 0.0F, 1, side > 0.0F ? 22000U : 23000U, light, light);
        const float aisle = side > 0.0F ? 3.9F : -7.2F;
        put_floor(site, aisle, aisle + 3.3F, 0.0F, 6, side > 0.0F ? 30000U : 33000U, light, dark);
        const float gallery = side > 0.0F ? 3.3F : -6.9F;
        put_floor(site, gallery, gallery + 3.6F, kGalleryFloor, 6, side > 0.0F ? 40000U : 43000U,
                  vec3(0.95F, 0.86F, 0.78F), vec3(0.9F, 0.8F, 0.7F));
    }
    site.put(Surface::kSoil, bevelled_box({16.0F, 0.5F, 24.0F}, 0.0F), at(0.0F, -0.3F, 0.0F), 1U);
}

/// A squared timber from a to b; the grain runs along it.
void put_beam(Site& site, vec3 a, vec3 b, float width, float height, std::uint32_t seed,
              float bevel = 0.0F) {
    const vec3 along = glm::normalize(b - a);
    const vec3 side = glm::normalize(glm::cross(along, vec3(0.0F, 1.0F, 0.0F)));
    const vec3 up = glm::cross(side, along);
    const glm::mat4 frame(glm::vec4(side, 0.0F), glm::vec4(along, 0.0F), glm::vec4(-up, 0.0F),
                          glm::vec4(0.5F * (a + b), 1.0F));
    const Mesh timber = bevelled_box({width, glm::length(b - a), height}, bevel);
    site.put(Surface::kWood, timber, frame, seed, shade(seed, 0.3F));
}

/// Boards, joists and main beams below a floor; `side` is -1 or +1.
void build_ceiling(Site& site, float side, float boards_y, float inner_x, float outer_x,
                   bool main_beams, std::uint32_t seed) {
    const auto x = [&](float distance) { return side * distance; };
    constexpr float kBoard = 0.24F;
    const int boards = static_cast<int>(std::round((outer_x - inner_x) / kBoard));
    for (int i = 0; i < boards; ++i) {
        const float middle = inner_x + (outer_x - inner_x) * (static_cast<float>(i) + 0.5F) /
                                           static_cast<float>(boards);
        // Boards lie edge to edge with their joints over the beams.
        const auto own = seed + static_cast<std::uint32_t>(i);
        put_beam(site, {x(middle), boards_y + 0.02F, -kHalfLength - 0.1F},
                 {x(middle), boards_y + 0.02F, kHalfLength + 0.1F}, kBoard + 0.004F, 0.04F, own);
    }
    constexpr int kJoists = 36;
    for (int i = 0; i < kJoists; ++i) {
        const float z =
            -kHalfLength + 2.0F * kHalfLength * (static_cast<float>(i) + 0.5F) / kJoists;
        const bool main_here = main_beams && i % 6 == 0;
        put_beam(site, {x(inner_x), boards_y - 0.075F, z}, {x(outer_x), boards_y - 0.075F, z},
                 0.11F, 0.17F, seed + 50U + static_cast<std::uint32_t>(i));
        if (!main_here || i == 0) continue;
        const float line = -kHalfLength + kBay * static_cast<float>(i / 6);
        put_beam(site, {x(inner_x), boards_y - 0.2F, line}, {x(outer_x), boards_y - 0.2F, line},
                 0.28F, 0.4F, seed + 100U + static_cast<std::uint32_t>(i), 0.02F);
        // A stone corbel carries the beam at the wall.
        site.put(Surface::kStone, bevelled_box({0.42F, 0.3F, 0.34F}, 0.05F),
                 at(x(outer_x - 0.2F), boards_y - 0.55F, line),
                 seed + static_cast<std::uint32_t>(i));
        site.put(Surface::kStone, bevelled_box({0.24F, 0.24F, 0.28F}, 0.05F),
                 at(x(outer_x - 0.1F), boards_y - 0.8F, line),
                 seed + static_cast<std::uint32_t>(i));
    }
}

/// Barrel tiles over a gallery: waves across, steps down the slope.
void build_roof(Site& site, float side, std::uint32_t seed) {
    constexpr float kPitch = 0.23F;
    constexpr float kCourse = 0.44F;
    constexpr float kInner = 2.9F;
    constexpr float kOuter = 7.3F;
    constexpr float kRise = 1.75F;
    const float length = 2.0F * kHalfLength + 0.8F;
    const int rolls = static_cast<int>(length / kPitch);
    const int courses = static_cast<int>((kOuter - kInner) / kCourse);
    PatchOptions options;
    options.columns = rolls * 4;
    options.size_m = {length, kOuter - kInner};
    options.rows = 1;
    const auto place = [&](int row, float u, float v) {
        const float roll = u * static_cast<float>(rolls);
        const int index = static_cast<int>(roll + 0.01F);
        const float wave = 0.058F * std::abs(std::sin(glm::pi<float>() * roll));
        const float slip = 0.03F * (hash_unit(index, row, 0, seed) - 0.5F);
        const float t = (static_cast<float>(row) + v * 1.12F) / static_cast<float>(courses);
        const float along = (u - 0.5F) * length;
        const float out = kInner + (kOuter - kInner) * t + slip * (1.0F - v);
        const float y = kEaves + 0.03F + kRise * t + wave + 0.035F * (1.0F - v);
        return vec3(side * out, y, side * along);
    };
    for (int row = 0; row < courses; ++row) {
        // u along side * z, v along side * x: z cross x is +y.
        const Mesh course = patch(options, [&](float u, float v) { return place(row, u, v); });
        const auto own = seed + static_cast<std::uint32_t>(row);
        site.put(Surface::kRoof, course, glm::mat4(1.0F), own, shade(own, 0.1F));
    }
    // The lowest tiles are bedded in mortar, a little behind their edge.
    options.size_m.y = 0.12F;
    const Mesh mortar = patch(options, [&](float u, float v) {
        const vec3 edge = place(0, u, 0.04F);
        return vec3(edge.x, glm::mix(kEaves, edge.y - 0.004F, v), edge.z);
    });
    site.put(Surface::kPlaster, mortar, glm::mat4(1.0F), seed + 30U, vec3(0.8F));
    // Closed below the tiles, with rafter ends under the eaves.
    const vec3 low(side * (kInner - 0.03F), kEaves, 0.0F);
    const vec3 high(side * kOuter, kEaves + kRise - 0.02F, 0.0F);
    const vec3 along = glm::normalize(high - low);
    const vec3 up = side * glm::cross(vec3(0.0F, 0.0F, 1.0F), along);
    const glm::mat4 frame(glm::vec4(along, 0.0F), glm::vec4(up, 0.0F),
                          glm::vec4(glm::cross(along, up), 0.0F),
                          glm::vec4(0.5F * (low + high), 1.0F));
    site.put(Surface::kWood, bevelled_box({glm::length(high - low), 0.04F, length}, 0.0F), frame,
             seed);
    // Each course hangs on a batten.
    for (int row = 0; row < courses; ++row) {
        const float up_slope = static_cast<float>(row + 1) / static_cast<float>(courses) - 0.5F;
        site.put(Surface::kWood, bevelled_box({0.04F, 0.05F, length - 0.1F}, 0.0F),
                 frame * at(up_slope * glm::length(high - low), 0.025F, 0.0F), seed + 31U);
    }
    constexpr int kRafters = 44;
    for (int i = 0; i < kRafters; ++i) {
        const float z =
            -kHalfLength + 2.0F * kHalfLength * (static_cast<float>(i) + 0.5F) / kRafters;
        const vec3 start = low + vec3(0.0F, -0.07F, z) + along * 0.04F;
        put_beam(site, start, start + along * 0.7F, 0.09F, 0.1F,
                 seed + 40U + static_cast<std::uint32_t>(i));
    }
}

}  // namespace

void build_shell(Site& site) {
    build_floors(site);
    for (const float side : {-1.0F, 1.0F}) {
        const std::uint32_t seed = side < 0.0F ? 50000U : 51000U;
        build_ceiling(site, side, kGalleryFloor - 0.3F, kArcadeX + kWallHalf - 0.05F,
                      kAisleWallX + 0.05F, true, seed);
        build_ceiling(site, side, kUpperTop - 0.06F, kArcadeX + 0.1F, kAisleWallX + 0.05F, false,
                      seed + 300U);
        build_roof(site, side, seed + 600U);
    }
}

}  // namespace obscura::stimuli::atrium
