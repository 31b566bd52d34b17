// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "stimuli/scenes/room/parts.h"

namespace obscura::stimuli::room {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

constexpr float kReveal = 0.22F;  ///< depth of the window's opening

void put_surface(Assembly& study, Surface surface, Mesh mesh, std::uint32_t seed,
                 const vec3& tint = vec3(1.0F)) {
    project_box_uv(mesh);
    study.put(surface, mesh, glm::mat4(1.0F), seed, tint);
}

void put_walls(Assembly& study) {
    const float w = kRight - kLeft;
    const float d = kFront - kBack;
    const vec3 up(0.0F, kHeight, 0.0F);
    put_surface(study, Surface::kWall, rectangle({kLeft, 0.0F, kBack}, {w, 0.0F, 0.0F}, up), 1U);
    put_surface(study, Surface::kWall, rectangle({kRight, 0.0F, kBack}, {0.0F, 0.0F, d}, up), 2U);
    put_surface(study, Surface::kWall, rectangle({kRight, 0.0F, kFront}, {-w, 0.0F, 0.0F}, up), 3U);
    // The wall with the window, in four pieces.
    const auto piece = [&](float z0, float z1, float y0, float y1) {
        put_surface(study, Surface::kWall,
                    rectangle({kLeft, y0, z1}, {0.0F, 0.0F, z0 - z1}, {0.0F, y1 - y0, 0.0F}), 4U);
    };
    piece(kBack, kWindowBack, 0.0F, kHeight);
    piece(kWindowFront, kFront, 0.0F, kHeight);
    piece(kWindowBack, kWindowFront, 0.0F, kSill);
    piece(kWindowBack, kWindowFront, kLintel, kHeight);
    put_surface(study, Surface::kFloor,
                rectangle({kLeft, 0.0F, kFront}, {w, 0.0F, 0.0F}, {0.0F, 0.0F, -d}), 5U);
    put_surface(study, Surface::kWall,
                rectangle({kLeft, kHeight, kBack}, {w, 0.0F, 0.0F}, {0.0F, 0.0F, d}), 6U,
                vec3(1.0F));
    // What lies on the ceiling: the sun's shadow map is too coarse to keep it off the cornice by a
    // plane alone.
    study.put(Surface::kWall, bevelled_box({w + 0.2F, 0.11F, d + 0.2F}, 0.004F),
              moved(0.5F * (kLeft + kRight), kHeight + 0.06F, 0.5F * (kFront + kBack)), 7U);
}

/// ProfileFrame, two casements of four panes each, a board inside below.
void put_window(Assembly& study) {
    const float z0 = kWindowBack;
    const float z1 = kWindowFront;
    const float width = z1 - z0;
    const float high = kLintel - kSill;
    const float middle_z = 0.5F * (z0 + z1);
    const float middle_y = 0.5F * (kSill + kLintel);
    // The opening's four sides.
    const float x = kLeft - kReveal;
    put_surface(study, Surface::kWall,
                rectangle({x, kSill, z0}, {kReveal, 0.0F, 0.0F}, {0.0F, high, 0.0F}), 11U);
    put_surface(study, Surface::kWall,
                rectangle({kLeft, kSill, z1}, {-kReveal, 0.0F, 0.0F}, {0.0F, high, 0.0F}), 12U);
    put_surface(study, Surface::kWall,
                rectangle({x, kLintel, z0}, {kReveal, 0.0F, 0.0F}, {0.0F, 0.0F, width}), 13U);
    put_surface(study, Surface::kWall,
                rectangle({x, kSill, z1}, {kReveal, 0.0F, 0.0F}, {0.0F, 0.0F, -width}), 14U);
    const auto bar = [&](const vec3& size, const vec3& at, std::uint32_t seed) {
        study.put(Surface::kLacquer, bevelled_box(size, 0.005F), moved(at), seed);
    };
    for (const float side : {-1.0F, 1.0F}) {
        bar({0.07F, high, 0.05F}, {x + 0.05F, middle_y, middle_z + side * (0.5F * width - 0.025F)},
            20U);
        bar({0.068F, 0.05F, width}, {x + 0.05F, middle_y + side * (0.5F * high - 0.025F), middle_z},
            21U);
        const float leaf_z = middle_z + side * 0.25F * width;
        const float leaf = 0.5F * width - 0.06F;
        for (const float edge : {-1.0F, 1.0F}) {
            bar({0.045F, high - 0.10F, 0.055F},
                {x + 0.075F, middle_y, leaf_z + edge * (0.5F * leaf - 0.027F)}, 22U);
            bar({0.043F, 0.06F, leaf},
                {x + 0.075F, middle_y + edge * (0.5F * high - 0.08F), leaf_z}, 23U);
        }
        bar({0.03F, 0.024F, leaf}, {x + 0.075F, middle_y + 0.12F, leaf_z}, 24U);
        bar({0.026F, high - 0.1F, 0.024F}, {x + 0.075F, middle_y, leaf_z}, 25U);
    }
    bar({0.034F, 0.036F, width + 0.22F}, {kLeft + 0.07F, kSill - 0.02F, middle_z}, 26U);
    bar({kReveal - 0.05F, 0.034F, width - 0.002F}, {kLeft - 0.035F, kSill - 0.012F, middle_z}, 27U);
    bar({0.07F, 0.034F, width + 0.22F}, {kLeft + 0.035F, kSill - 0.020F, middle_z}, 27U);
    // An architrave round it.
    for (const float side : {-1.0F, 1.0F}) {
        bar({0.022F, high + 0.16F, 0.09F},
            {kLeft + 0.011F, middle_y + 0.045F, middle_z + side * (0.5F * width + 0.047F)}, 28U);
        bar({0.034F, high + 0.17F, 0.022F},
            {kLeft + 0.017F, middle_y + 0.045F, middle_z + side * (0.5F * width + 0.088F)}, 28U);
    }
    bar({0.022F, 0.09F, width + 0.2F}, {kLeft + 0.0095F, kLintel + 0.047F, middle_z}, 29U);
    bar({0.045F, 0.03F, width + 0.26F}, {kLeft + 0.022F, kLintel + 0.105F, middle_z}, 29U);
    study.put(Surface::kMetal, bevelled_box({0.02F, 0.12F, 0.03F}, 0.006F),
              moved(x + 0.105F, middle_y - 0.1F, middle_z - 0.03F), 30U);
    study.put(Surface::kMetal,
              rod({x + 0.11F, middle_y - 0.08F, middle_z - 0.03F},
                  {x + 0.15F, middle_y - 0.19F, middle_z - 0.03F}, 0.008F),
              glm::mat4(1.0F), 30U);
}

/// Skirting and a cornice along a wall; the room lies on the side of cross(to - from, up).
void put_mouldings(Assembly& study, const vec3& from, const vec3& to) {
    const vec3 way = glm::normalize(to - from);
    const vec3 out = glm::cross(way, vec3(0.0F, 1.0F, 0.0F));
    const std::array<vec2, 9> skirting{{{-0.01F, 0.0F},
                                        {0.020F, 0.0F},
                                        {0.020F, 0.095F},
                                        {0.017F, 0.105F},
                                        {0.011F, 0.110F},
                                        {0.013F, 0.118F},
                                        {0.010F, 0.128F},
                                        {0.003F, 0.134F},
                                        {-0.01F, 0.134F}}};
    std::vector<vec2> cornice{{-0.01F, -0.09F}, {0.008F, -0.09F}, {0.012F, -0.082F}};
    for (int i = 0; i <= 6; ++i) {
        const float a = 1.5708F * static_cast<float>(i) / 6.0F;
        cornice.emplace_back(0.075F - 0.06F * std::cos(a), -0.075F + 0.06F * std::sin(a));
    }
    cornice.emplace_back(0.085F, -0.005F);
    cornice.emplace_back(0.085F, 0.01F);
    cornice.emplace_back(-0.01F, 0.01F);
    SweepOptions options;
    options.crease_rad = 0.5F;
    const auto along = [&](float y) {
        // x of the profile points into the room, so the path runs along cross(out, up).
        const vec3 start =
            glm::dot(glm::cross(out, vec3(0.0F, 1.0F, 0.0F)), way) > 0.0F ? from : to;
        const vec3 end = start == from ? to : from;
        std::vector<ProfileFrame> frames;
        for (int i = 0; i <= 10; ++i) {
            const vec3 p = glm::mix(start, end, static_cast<float>(i) / 10.0F);
            frames.push_back({p + vec3(0.0F, y, 0.0F), out, {0.0F, 1.0F, 0.0F}});
        }
        return frames;
    };
    study.put(Surface::kLacquer, sweep(skirting, along(0.0F), options), glm::mat4(1.0F), 40U);
    study.put(Surface::kWall, sweep(cornice, along(kHeight), options), glm::mat4(1.0F), 41U);
}

/// A panelled door with its frame in the right wall, in front of the shelves.
void put_door(Assembly& study) {
    const glm::mat4 place = moved(kRight, 0.0F, 0.6F);
    study.put(Surface::kLacquer, bevelled_box({0.04F, 2.02F, 0.84F}, 0.004F),
              place * moved(-0.002F, 1.01F, 0.0F), 50U);
    for (const float y : {0.42F, 1.38F}) {
        for (const float z : {-0.2F, 0.2F}) {
            const float high = y < 1.0F ? 0.5F : 0.95F;
            study.put(Surface::kLacquer, bevelled_box({0.012F, high, 0.28F}, 0.005F),
                      place * moved(-0.022F, y + 0.05F, z), 51U);
            study.put(Surface::kLacquer, bevelled_box({0.014F, high - 0.09F, 0.19F}, 0.007F),
                      place * moved(-0.028F, y + 0.05F, z), 52U);
        }
    }
    for (const float z : {-0.47F, 0.47F}) {
        study.put(Surface::kLacquer, bevelled_box({0.05F, 2.12F, 0.09F}, 0.008F),
                  place * moved(-0.01F, 1.06F, z), 53U);
    }
    study.put(Surface::kLacquer, bevelled_box({0.048F, 0.09F, 1.03F}, 0.008F),
              place * moved(-0.01F, 2.1F, 0.0F), 54U);
    const std::array<vec2, 8> knob{{{0.0F, 0.0F},
                                    {0.028F, 0.0F},
                                    {0.026F, 0.008F},
                                    {0.011F, 0.014F},
                                    {0.011F, 0.035F},
                                    {0.026F, 0.045F},
                                    {0.024F, 0.062F},
                                    {0.0F, 0.068F}}};
    study.put(Surface::kMetal, revolve(knob, 24),
              place * moved(-0.02F, 1.0F, -0.36F) * about_z(1.5708F), 55U);
}

}  // namespace

void build_shell(Assembly& study) {
    put_walls(study);
    put_window(study);
    put_mouldings(study, {kLeft, 0.0F, kBack}, {kRight, 0.0F, kBack});
    put_mouldings(study, {kLeft, 0.0F, kFront}, {kLeft, 0.0F, kBack});
    put_mouldings(study, {kRight, 0.0F, kBack}, {kRight, 0.0F, kFront});
    put_door(study);
}

}  // namespace obscura::stimuli::room
