// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
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

/// A hanging cloth with its upper edge on a rod along x, from y = 0 downwards.
struct Drape {
    float width = 2.4F;  ///< of the cloth as it hangs at the top
    float height = 4.6F;
    float gather = 1.0F;   ///< share of the width that is left at the tie, 1 = hangs free
    float tie = 0.62F;     ///< where it is tied, from the top
    float towards = 0.0F;  ///< the side the tie pulls to: -1 left, +1 right
    int folds = 11;
    float depth = 0.075F;  ///< of the folds
    std::uint32_t seed = 0;
};

/// How much of its width a drape has at v, 1 at the rod.
float width_at(const Drape& drape, float v) {
    const float above = glm::smoothstep(0.0F, drape.tie, v);
    const float below = glm::smoothstep(drape.tie, 1.0F, v);
    const float tied = v < drape.tie ? glm::mix(1.0F, drape.gather, above * above)
                                     : glm::mix(drape.gather, 0.62F, 0.8F * below);
    return drape.gather < 1.0F ? tied : 1.0F;
}

vec3 drape_point(const Drape& drape, float u, float v) {
    const float width = width_at(drape, v);
    const float wander = 0.08F * fbm(vec2(u * 5.0F, v * 1.3F), drape.seed, 3) * v;
    const float wave = u + wander + 0.022F * std::sin(9.0F * u + static_cast<float>(drape.seed));
    const float phase = wave * static_cast<float>(drape.folds) * glm::two_pi<float>();
    const float strength =
        0.55F +
        0.45F * value_noise(vec2(u * static_cast<float>(drape.folds), v * 1.5F), drape.seed + 1U);
    const float fuller =
        drape.depth * (0.6F + 0.4F * glm::smoothstep(0.0F, 0.2F, v)) * glm::mix(0.42F, 1.0F, width);
    // Rounded crests, and edges that lean over as heavy cloth does.
    const float z = fuller * strength * (std::sin(phase) + 0.22F * std::sin(2.0F * phase + 0.7F));
    const float lean = 0.2F * drape.width / static_cast<float>(drape.folds) * width *
                       std::cos(phase + 0.4F) * glm::smoothstep(0.0F, 0.3F, v);
    // Heavy cloth hangs straight nowhere: its edges swing out and in on their way down.
    const float swing = 0.11F * fbm(vec2(u * 2.0F, v * 3.5F), drape.seed + 3U, 3) *
                        glm::smoothstep(0.0F, 0.3F, v) * width;
    const float anchor = 0.5F * drape.towards;
    const float x = drape.width * (anchor + (u - 0.5F - anchor) * width) + lean + swing;
    const float sag = 0.02F * std::sin(phase) * (1.0F - glm::smoothstep(0.0F, 0.06F, v));
    const float hem = 0.03F * fbm(vec2(u * 6.0F, 0.5F), drape.seed + 2U, 3) * v;
    return {x, -drape.height * v + sag + hem, z};
}

void put_drape(Site& site, const Drape& drape, const vec3& dye, const glm::mat4& frame) {
    struct Strip {
        float from;
        float to;
        int rows;
        vec3 colour;
    };
    const std::array<Strip, 3> strips{
        {{0.0F, 0.945F, 22, dye}, {0.945F, 0.982F, 1, kDyeGold}, {0.982F, 1.0F, 1, dye}}};
    for (const Strip& strip : strips) {
        PatchOptions options;
        options.columns = drape.folds * 7;
        options.rows = strip.rows;
        options.size_m = {drape.width * 1.5F, drape.height * (strip.to - strip.from)};
        // u runs leftwards and v downwards, so the cloth faces +z.
        Mesh mesh = patch(options, [&](float u, float v) {
            return drape_point(drape, 1.0F - u, strip.from + (strip.to - strip.from) * v);
        });
        // Over sharp folds the triangles' own normals are the true ones.
        smooth_normals(mesh, 1.9F);
        for (Vertex& vertex : mesh.vertices) {
            const float down = -vertex.position_m.y / drape.height;
            const float sunned = 1.0F - 0.18F * value_noise(vertex.position_m * 1.3F, drape.seed);
            const float dusty = 0.16F * glm::smoothstep(0.8F, 1.0F, down);
            const vec3 colour = glm::mix(strip.colour * sunned, vec3(0.30F, 0.25F, 0.18F), dusty);
            vertex.color = glm::u8vec4(glm::vec4(colour * 255.0F + 0.5F, 255.0F));
        }
        site.put(Surface::kCloth, mesh, frame, drape.seed);
    }
}

void put_rod(Site& site, float length, const glm::mat4& frame) {
    const std::vector<vec3> path{{-0.5F * length, 0.0F, 0.0F}, {0.5F * length, 0.0F, 0.0F}};
    site.put(Surface::kIron, sweep(circle(0.02F, 10), frames_along(path, {0.0F, 1.0F, 0.0F})),
             frame, 1U);
    const Mesh knob = revolve(
        std::vector<vec2>{
            {0.0F, -0.05F}, {0.035F, -0.035F}, {0.05F, 0.0F}, {0.035F, 0.035F}, {0.0F, 0.05F}},
        12);
    std::vector<vec3> loop;
    for (const vec2& point : circle(0.035F, 9)) loop.emplace_back(0.0F, point.x, point.y);
    SweepOptions closed;
    closed.closed_path = true;
    const Mesh ring =
        sweep(circle(0.006F, 4), frames_along(loop, {1.0F, 0.0F, 0.0F}, true), closed);
    for (const float side : {-0.5F, 0.5F}) {
        site.put(Surface::kIron, knob, frame * at(side * length, 0.0F, 0.0F), 2U);
    }
    constexpr int kRings = 10;
    for (int i = 0; i < kRings; ++i) {
        const float x = length * 0.96F * ((static_cast<float>(i) + 0.5F) / kRings - 0.5F);
        site.put(Surface::kIron, ring, frame * at(x, -0.012F, 0.0F), 3U);
    }
    // Brackets to the wall, which is towards the court.
    for (const float side : {-0.42F, 0.42F}) {
        site.put(Surface::kIron, bevelled_box({0.03F, 0.03F, 0.3F}, 0.006F),
                 frame * at(side * length, 0.0F, 0.14F), 4U);
    }
}

void put_tie(Site& site, vec3 centre, float width, const glm::mat4& frame) {
    std::vector<vec3> loop;
    for (const vec2& point : circle(1.0F, 20)) {
        loop.emplace_back(centre + vec3(0.5F * width * point.x, -0.10F * point.x, 0.12F * point.y));
    }
    SweepOptions closed;
    closed.closed_path = true;
    const std::vector<vec2> band{{-0.02F, -0.05F}, {0.0F, -0.055F}, {0.02F, -0.05F},
                                 {0.02F, 0.05F},   {0.0F, 0.055F},  {-0.02F, 0.05F}};
    site.put(Surface::kCloth, sweep(band, frames_along(loop, {0.0F, 1.0F, 0.0F}, true), closed),
             frame, 5U, kDyeGold);
}

/// Curtains behind a lower arch, on the aisle's side of its wall. `style`: 0 parted in the middle
/// and tied, 1 drawn to the left, 2 drawn to the right, 3 hanging free.
void put_curtains(Site& site, const glm::mat4& bay, int style, const vec3& dye,
                  std::uint32_t seed) {
    constexpr float kRodY = 4.98F;
    const glm::mat4 frame = bay * at(0.0F, kRodY, -kWallHalf - 0.29F);
    put_rod(site, 3.2F, frame);
    const glm::mat4 cloth = frame * at(0.0F, -0.05F, 0.0F);
    Drape drape;
    drape.height = kRodY - 0.085F;  // the hem all but touches the floor
    drape.seed = seed;
    if (style == 3) {
        drape.width = 2.75F;
        drape.folds = 15;
        put_drape(site, drape, dye, cloth);
        return;
    }
    const bool parted = style == 0;
    for (const float side : {-1.0F, 1.0F}) {
        if (!parted && (side < 0.0F) != (style == 1)) continue;
        drape.width = parted ? 1.5F : 2.2F;
        drape.folds = parted ? 9 : 12;
        drape.gather = parted ? 0.3F : 0.26F;
        drape.towards = side;
        drape.seed = seed + (side > 0.0F ? 11U : 0U);
        const float middle = parted ? side * 0.76F : side * 0.4F;
        put_drape(site, drape, dye, cloth * at(middle, 0.0F, 0.0F));
        const float at_tie = drape.width * drape.gather;
        const float x = middle + side * 0.5F * (drape.width - at_tie);
        put_tie(site, {x, -drape.height * drape.tie, 0.0F}, at_tie + 0.03F, cloth);
    }
}

/// A cloth laid over the balustrade, falling down to the arches; `dye` 0 red, 1 green, 2 blue.
void put_banner(Site& site, const glm::mat4& bay, float x, float width, float drop, int dye,
                std::uint32_t seed) {
    PatchOptions options;
    options.columns = 22;
    options.rows = 40;
    constexpr float kRail = 6.5F;
    constexpr float kInside = 0.55F;  // length on the gallery's side
    constexpr float kOver = 0.30F;
    const float length = kInside + kOver + drop;
    options.size_m = {width, length};
    Mesh mesh = patch(options, [&](float u, float v) {
        const float along = length * v;
        const float fold = std::sin((u + 0.06F * fbm(vec2(u * 3.0F, v * 2.0F), seed, 3)) * 26.0F);
        const float across = width * (0.5F - u);
        if (along < kInside) {
            return vec3(across, kRail + 0.012F - kInside + along, -0.168F - 0.006F * fold);
        }
        if (along < kInside + kOver) {
            const float t = (along - kInside) / kOver;
            const float angle = glm::pi<float>() * t;
            return vec3(across, kRail + 0.012F + 0.02F * std::sin(angle),
                        -0.168F * std::cos(angle));
        }
        const float t = along - kInside - kOver;
        const float loose = glm::smoothstep(0.0F, 0.9F, t);
        // It hangs clear of the string course.
        const float clear = 0.168F + 0.27F * glm::smoothstep(0.0F, 0.75F, t);
        const float billow = 0.05F * fbm(vec2(u * 1.5F, t * 0.8F), seed + 1U, 2) * loose;
        return vec3(across * (1.0F - 0.04F * loose), kRail + 0.012F - t,
                    clear + billow + 0.022F * loose * fold);
    });
    for (Vertex& vertex : mesh.vertices) {
        // The texture's lower end is the banner's; which third is its colour.
        vertex.uv = {(static_cast<float>(dye) + vertex.uv.x / width) / 3.0F,
                     1.0F - (length - vertex.uv.y) / 3.0F};
        const float tone = 1.0F - 0.2F * value_noise(vertex.position_m * 1.7F, seed);
        vertex.color = glm::u8vec4(glm::vec4(vec3(tone * 255.0F), 255.0F));
    }
    site.put_mapped(Surface::kBanner, mesh, bay * at(x, 0.0F, -0.08F + kWallHalf));
}

}  // namespace

void build_cloth(Site& site) {
    struct Hanging {
        int side;
        int bay;
        int style;
        vec3 dye;
    };
    // Bays count along the side's own x axis: towards -z on the left side (-1), +z on the right.
    const std::vector<Hanging> hangings{
        {1, 0, 0, kDyeRed},  {1, 1, 2, kDyeGreen}, {1, 3, 0, kDyeBlue},   {1, 4, 1, kDyeRed},
        {-1, 1, 1, kDyeRed}, {-1, 2, 0, kDyeBlue}, {-1, 4, 0, kDyeGreen}, {-1, 5, 2, kDyeRed},
    };
    for (const Hanging& hanging : hangings) {
        const float x = -kHalfLength + kBay * (static_cast<float>(hanging.bay) + 0.5F);
        put_curtains(
            site, side_frame(hanging.side, kArcadeX) * at(x, 0.0F, 0.0F), hanging.style,
            hanging.dye,
            80000U + 100U * static_cast<std::uint32_t>(hanging.bay + 10 * hanging.side + 20));
    }
    struct Banner {
        int side;
        int bay;
        float x;
        float drop;
        int dye;  // the third of the texture: red, green, blue
    };
    const std::vector<Banner> banners{{1, 1, -0.84F, 2.5F, 2},  {1, 2, 0.84F, 2.1F, 1},
                                      {1, 4, -0.84F, 2.5F, 0},  {-1, 1, 0.84F, 2.3F, 1},
                                      {-1, 3, -0.84F, 2.5F, 0}, {-1, 4, 0.84F, 2.2F, 2}};
    for (const Banner& banner : banners) {
        const float x = -kHalfLength + kBay * (static_cast<float>(banner.bay) + 0.5F);
        put_banner(site, side_frame(banner.side, kArcadeX) * at(x, 0.0F, 0.0F), banner.x, 1.05F,
                   banner.drop, banner.dye,
                   90000U + 10U * static_cast<std::uint32_t>(banner.bay + 10 * banner.side + 20));
    }
}

}  // namespace obscura::stimuli::atrium
