// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/machine/parts.h"

namespace obscura::stimuli::machine {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

constexpr float kLeft = -3.2F;
constexpr float kRight = 3.4F;
constexpr float kFront = 4.6F;
constexpr float kTop = 4.4F;
constexpr float kTiles = 1.42F;  ///< height of the tiled part of the walls
// The pit in the floor that the grating covers.
constexpr float kPitLeft = -1.55F;
constexpr float kPitRight = 0.85F;
constexpr float kPitBack = 0.66F;
constexpr float kPitFront = 1.36F;
constexpr float kPitDepth = 0.42F;

void put_floor_piece(Assembly& hall, float x0, float x1, float z0, float z1) {
    Mesh piece = rectangle({x0, 0.0F, z1}, {x1 - x0, 0.0F, 0.0F}, {0.0F, 0.0F, z0 - z1}, 0.5F);
    project_box_uv(piece);
    hall.put(Surface::kConcrete, piece, glm::mat4(1.0F), 800U);
}

void put_floor(Assembly& hall) {
    put_floor_piece(hall, kLeft, kRight, kWallZ, kPitBack);
    put_floor_piece(hall, kLeft, kPitLeft, kPitBack, kPitFront);
    put_floor_piece(hall, kPitRight, kRight, kPitBack, kPitFront);
    put_floor_piece(hall, kLeft, kRight, kPitFront, kFront);
    hall.put(Surface::kConcrete, bevelled_box({3.45F, kFoundationTop, 1.0F}, 0.02F),
             moved(0.02F, 0.5F * kFoundationTop, 0.0F), 801U, vec3(0.9F));
    hall.put(Surface::kConcrete, bevelled_box({0.62F, kFoundationTop, 0.30F}, 0.02F),
             moved(kCrankX, 0.5F * kFoundationTop, -0.90F), 802U, vec3(0.9F));
    const float w = kPitRight - kPitLeft;
    const float d = kPitFront - kPitBack;
    const vec3 down(0.0F, -kPitDepth, 0.0F);
    const vec3 tint(0.55F);
    hall.put(Surface::kConcrete,
             rectangle({kPitLeft, -kPitDepth, kPitBack}, {w, 0.0F, 0.0F}, -down), glm::mat4(1.0F),
             803U, tint);
    hall.put(Surface::kConcrete,
             rectangle({kPitRight, -kPitDepth, kPitFront}, {-w, 0.0F, 0.0F}, -down),
             glm::mat4(1.0F), 804U, tint);
    hall.put(Surface::kConcrete,
             rectangle({kPitLeft, -kPitDepth, kPitFront}, {0.0F, 0.0F, -d}, -down), glm::mat4(1.0F),
             805U, tint);
    hall.put(Surface::kConcrete,
             rectangle({kPitRight, -kPitDepth, kPitBack}, {0.0F, 0.0F, d}, -down), glm::mat4(1.0F),
             806U, tint);
    hall.put(Surface::kConcrete,
             rectangle({kPitLeft, -kPitDepth, kPitFront}, {w, 0.0F, 0.0F}, {0.0F, 0.0F, -d}),
             glm::mat4(1.0F), 807U, tint);
    for (int i = 0; i < 4; ++i) {
        const float z = kPitBack + 0.12F + 0.15F * static_cast<float>(i);
        hall.put(i == 2 ? Surface::kCopper : Surface::kCast,
                 rod({kPitLeft, -0.3F, z}, {kPitRight, -0.3F, z},
                     0.03F + 0.01F * static_cast<float>(i % 2), 16),
                 glm::mat4(1.0F), 808U);
    }
}

/// Bearing bars on edge, twisted cross bars, and the angle that they lie in.
void put_grating(Assembly& hall) {
    const float depth = kPitFront - kPitBack;
    const Mesh bar = bevelled_box({0.0045F, 0.03F, depth - 0.012F}, 0.0008F);
    const int bars = static_cast<int>((kPitRight - kPitLeft) / 0.03F);
    for (int i = 0; i < bars; ++i) {
        const auto seed = 820U + static_cast<std::uint32_t>(i);
        hall.put(Surface::kZinc, bar,
                 moved(kPitLeft + 0.03F * (static_cast<float>(i) + 0.5F), -0.014F,
                       0.5F * (kPitBack + kPitFront)),
                 seed, shade_of(seed, 0.3F));
    }
    std::vector<vec2> square{
        {0.0032F, -0.0032F}, {0.0032F, 0.0032F}, {-0.0032F, 0.0032F}, {-0.0032F, -0.0032F}};
    for (int i = 0; i < 7; ++i) {
        const float z = kPitBack + depth * (static_cast<float>(i) + 0.5F) / 7.0F;
        std::vector<ProfileFrame> frames;
        constexpr int kSteps = 240;
        for (int k = 0; k <= kSteps; ++k) {
            const float x = kPitLeft + (kPitRight - kPitLeft) * static_cast<float>(k) / kSteps;
            const float a = 0.6F * static_cast<float>(k);
            frames.push_back({{x, -0.0035F, z},
                              {0.0F, std::cos(a), std::sin(a)},
                              {0.0F, -std::sin(a), std::cos(a)}});
        }
        hall.put(Surface::kZinc, sweep(square, frames), glm::mat4(1.0F), 900U);
    }
    for (const float z : {kPitBack - 0.02F, kPitFront + 0.02F}) {
        hall.put(Surface::kZinc,
                 bevelled_box({kPitRight - kPitLeft + 0.08F, 0.01F, 0.045F}, 0.002F),
                 moved(0.5F * (kPitLeft + kPitRight), 0.004F, z), 901U, vec3(0.75F));
    }
    for (const float x : {kPitLeft - 0.02F, kPitRight + 0.02F}) {
        hall.put(Surface::kZinc, bevelled_box({0.045F, 0.01F, kPitFront - kPitBack}, 0.002F),
                 moved(x, 0.004F, 0.5F * (kPitBack + kPitFront)), 902U, vec3(0.75F));
    }
}

/// Steel plates with raised lozenges laid over the floor.
void put_chequer_plate(Assembly& hall, float x0, float x1, float z0, float z1, std::uint32_t seed) {
    hall.put(Surface::kZinc, bevelled_box({x1 - x0, 0.008F, z1 - z0}, 0.002F),
             moved(0.5F * (x0 + x1), 0.005F, 0.5F * (z0 + z1)), seed, vec3(0.62F, 0.60F, 0.57F));
    PatchOptions options;
    options.columns = 6;
    options.rows = 2;
    options.size_m = {0.032F, 0.011F};
    const Mesh lozenge = patch(options, [](float u, float v) {
        const float along = 2.0F * u - 1.0F;
        const float half = 0.0055F * (1.0F - along * along);
        const float across = 2.0F * v - 1.0F;
        return vec3(0.016F * along,
                    0.0022F * (1.0F - across * across) * (1.0F - 0.7F * along * along),
                    -half * across);
    });
    constexpr float kPitch = 0.036F;
    const int columns = static_cast<int>((x1 - x0 - 0.03F) / kPitch);
    const int rows = static_cast<int>((z1 - z0 - 0.03F) / kPitch);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const float turn = (i + j) % 2 == 0 ? 0.785F : -0.785F;
            hall.put(Surface::kZinc, lozenge,
                     moved(x0 + 0.03F + kPitch * static_cast<float>(i), 0.009F,
                           z0 + 0.03F + kPitch * static_cast<float>(j)) *
                         about_y(turn),
                     seed + 1U, vec3(0.78F, 0.76F, 0.73F));
        }
    }
    for (const float x : {x0 + 0.02F, x1 - 0.02F}) {
        for (const float z : {z0 + 0.02F, z1 - 0.02F}) {
            hall.put(Surface::kSteel, bolt(0.008F), moved(x, 0.008F, z), seed + 2U);
        }
    }
}

/// A wall from `from` along `edge` with tiles below, a moulded cap and brick above.
void put_wall(Assembly& hall, const vec3& from, const vec3& edge, std::uint32_t seed) {
    const vec3 out = glm::normalize(glm::cross(edge, vec3(0.0F, 1.0F, 0.0F)));
    Mesh tiles = rectangle(from, edge, {0.0F, kTiles, 0.0F}, 0.6F);
    project_box_uv(tiles);
    hall.put(Surface::kTile, tiles, glm::mat4(1.0F), seed);
    // The bricks lie a little behind the tiles and run on behind the corners.
    const vec3 more = 0.05F * glm::normalize(edge);
    Mesh bricks = rectangle(from + vec3(0.0F, kTiles, 0.0F) - out * 0.03F - more,
                            edge + 2.0F * more, {0.0F, kTop - kTiles, 0.0F}, 0.6F);
    project_box_uv(bricks);
    hall.put(Surface::kBrick, bricks, glm::mat4(1.0F), seed);
    const float length = glm::length(edge);
    const glm::mat4 along(glm::vec4(glm::normalize(edge), 0.0F), glm::vec4(0.0F, 1.0F, 0.0F, 0.0F),
                          glm::vec4(out, 0.0F), glm::vec4(from + 0.5F * edge, 1.0F));
    hall.put(Surface::kTile, bevelled_box({length, 0.05F, 0.09F}, 0.018F),
             along * moved(0.0F, kTiles + 0.01F, -0.02F), seed, vec3(0.8F));
    hall.put(Surface::kTile, bevelled_box({length, 0.14F, 0.05F}, 0.015F),
             along * moved(0.0F, 0.06F, 0.0F), seed + 1U, vec3(0.6F));
    for (float x = -0.5F * length + 0.7F; x < 0.5F * length; x += 2.1F) {
        Mesh pilaster = bevelled_box({0.42F, kTop - kTiles, 0.16F}, 0.008F);
        hall.put(Surface::kBrick, pilaster, along * moved(x, 0.5F * (kTop + kTiles) + 0.03F, 0.02F),
                 seed + 2U);
    }
}

/// The wall behind the viewer, for the sun to come through: brick piers between iron windows.
void put_window_wall(Assembly& hall) {
    constexpr float kSill = 1.3F;
    constexpr float kWindowTop = 6.4F;
    constexpr float kPier = 0.55F;
    constexpr float kStep = 2.2F;
    const float z = kFront + 0.06F;
    hall.put(Surface::kBrick, bevelled_box({kRight - kLeft + 0.3F, kSill, 0.3F}, 0.01F),
             moved(0.5F * (kLeft + kRight), 0.5F * kSill, z), 960U);
    for (float x = kLeft; x < kRight + 0.1F; x += kStep) {
        hall.put(Surface::kBrick, bevelled_box({kPier, kWindowTop - kSill + 0.02F, 0.3F}, 0.01F),
                 moved(x, 0.5F * (kSill + kWindowTop), z), 961U);
        for (int i = 1; i < 4; ++i) {
            const float bar = x + 0.5F * kPier + (kStep - kPier) * static_cast<float>(i) / 4.0F;
            if (bar > kRight) continue;
            hall.put(Surface::kCast,
                     bevelled_box({0.035F, kWindowTop - kSill + 0.02F, 0.05F}, 0.004F),
                     moved(bar, 0.5F * (kSill + kWindowTop), z), 962U);
        }
    }
    for (float y = kSill + 0.62F; y < kWindowTop; y += 0.62F) {
        hall.put(Surface::kCast, bevelled_box({kRight - kLeft, 0.03F, 0.04F}, 0.004F),
                 moved(0.5F * (kLeft + kRight), y, z), 963U);
    }
}

void put_pipe_run(Assembly& hall) {
    constexpr std::array<float, 5> kRadius{0.045F, 0.028F, 0.028F, 0.060F, 0.02F};
    const std::array<vec3, 5> tint{kCream, kRed, kBlueGrey, kGreen, kYellow};
    float y = 1.62F;
    for (std::size_t i = 0; i < kRadius.size(); ++i) {
        y += kRadius[i] + 0.028F;
        const float z = kWallZ + 0.16F + kRadius[i];
        // The lowest turns last: none passes through one above it.
        const float turn_x = 1.66F - 0.12F * static_cast<float>(i);
        const std::array<vec3, 5> path{{{kLeft, y, z},
                                        {turn_x, y, z},
                                        {turn_x, y + 0.75F, z},
                                        {turn_x + 0.6F, y + 0.75F, z},
                                        {kRight, y + 0.75F, z}}};
        hall.put(i == 2 ? Surface::kCopper : Surface::kEnamel, pipe(path, 0.14F, kRadius[i], 24),
                 glm::mat4(1.0F), 850U + static_cast<std::uint32_t>(i),
                 i == 2 ? vec3(1.0F) : tint[i]);
        for (const float x : {-2.45F, -0.35F, 0.75F}) {
            put_joint(hall, Surface::kCast,
                      moved(x + 0.09F * static_cast<float>(i), y, z) * lie_along_x(), kRadius[i]);
        }
        for (float x = -2.9F; x < 1.1F; x += 0.95F) {
            hall.put(Surface::kZinc, ring(kRadius[i] + 0.004F, 0.006F, 24, 6),
                     moved(x, y, z) * lie_along_x(), 860U);
        }
        y += kRadius[i];
    }
    for (float x = -2.9F; x < 1.1F; x += 0.95F) {
        hall.put(Surface::kZinc, bevelled_box({0.04F, 0.66F, 0.04F}, 0.004F),
                 moved(x, 1.94F, kWallZ + 0.13F), 861U, vec3(0.7F));
        for (const float up : {1.66F, 2.22F}) {
            hall.put(Surface::kZinc, bevelled_box({0.035F, 0.035F, 0.16F}, 0.004F),
                     moved(x, up, kWallZ + 0.06F), 862U, vec3(0.7F));
        }
    }
}

void put_cable_tray(Assembly& hall) {
    const float y = 2.98F;
    const float z = kWallZ + 0.22F;
    for (const float off : {-0.14F, 0.14F}) {
        hall.put(Surface::kZinc, bevelled_box({kRight - kLeft, 0.05F, 0.004F}, 0.0F),
                 moved(0.5F * (kLeft + kRight), y, z + off), 870U);
    }
    for (float x = kLeft + 0.1F; x < kRight; x += 0.16F) {
        hall.put(Surface::kZinc, bevelled_box({0.03F, 0.008F, 0.28F}, 0.0F), moved(x, y - 0.02F, z),
                 871U);
    }
    for (int i = 0; i < 7; ++i) {
        std::vector<vec3> path;
        for (int k = 0; k <= 40; ++k) {
            const float x = kLeft + (kRight - kLeft) * static_cast<float>(k) / 40.0F;
            path.emplace_back(x, y - 0.003F + 0.004F * std::sin(2.3F * x + static_cast<float>(i)),
                              z - 0.115F + 0.036F * static_cast<float>(i) +
                                  0.008F * std::sin(1.7F * x + 2.0F * static_cast<float>(i)));
        }
        hall.put(Surface::kRubber,
                 sweep(circle(0.010F + 0.002F * static_cast<float>(i % 3), 10),
                       frames_along(path, {0.0F, 1.0F, 0.0F})),
                 glm::mat4(1.0F), 872U + static_cast<std::uint32_t>(i),
                 i % 3 == 1 ? vec3(1.0F) : vec3(0.8F));
    }
}

/// A steel cabinet with louvred doors, meters and lamps.
void put_cabinet(Assembly& hall) {
    const glm::mat4 place = moved(2.25F, 0.0F, kWallZ + 0.22F);
    hall.put(Surface::kConcrete, bevelled_box({0.98F, 0.1F, 0.46F}, 0.01F),
             place * moved(0.0F, 0.05F, 0.0F), 880U, vec3(0.7F));
    hall.put(Surface::kEnamel, bevelled_box({0.94F, 1.9F, 0.40F}, 0.012F),
             place * moved(0.0F, 1.05F, 0.0F), 881U, kBlueGrey);
    for (const float side : {-1.0F, 1.0F}) {
        const glm::mat4 door = place * moved(side * 0.232F, 0.75F, 0.205F);
        hall.put(Surface::kEnamel, bevelled_box({0.44F, 1.20F, 0.018F}, 0.006F), door, 882U,
                 kBlueGrey);
        for (int i = 0; i < 22; ++i) {
            const float y = -0.45F + 0.024F * static_cast<float>(i);
            hall.put(Surface::kEnamel, bevelled_box({0.28F, 0.020F, 0.003F}, 0.001F),
                     door * moved(0.0F, y, 0.016F) * about_x(0.7F), 883U, kBlueGrey);
        }
        hall.put(Surface::kSteel, bevelled_box({0.02F, 0.12F, 0.03F}, 0.006F),
                 door * moved(-side * 0.18F, 0.28F, 0.02F), 884U);
        for (const float y : {-0.5F, 0.5F}) {
            hall.put(
                Surface::kSteel,
                rod({side * 0.222F, y - 0.04F, 0.012F}, {side * 0.222F, y + 0.04F, 0.012F}, 0.011F),
                door, 885U);
        }
    }
    for (int i = 0; i < 3; ++i)
        put_gauge(hall, place * moved(-0.28F + 0.28F * static_cast<float>(i), 1.74F, 0.20F),
                  0.085F);
    for (int i = 0; i < 6; ++i) {
        const std::array<vec2, 5> knob{
            {{0.0F, 0.0F}, {0.02F, 0.0F}, {0.02F, 0.015F}, {0.014F, 0.028F}, {0.0F, 0.03F}}};
        hall.put(Surface::kEnamel, revolve(knob, 16),
                 place * moved(-0.3F + 0.12F * static_cast<float>(i), 1.49F, 0.20F) * lie_along_z(),
                 886U, i % 2 == 0 ? kRed : kGreen);
    }
}

}  // namespace

void build_hall(Assembly& hall) {
    put_floor(hall);
    put_grating(hall);
    put_chequer_plate(hall, -3.0F, kPitLeft - 0.06F, 0.62F, 1.40F, 910U);
    put_chequer_plate(hall, kPitRight + 0.06F, 2.2F, 0.62F, 1.40F, 920U);
    put_wall(hall, {kLeft, 0.0F, kWallZ}, {kRight - kLeft, 0.0F, 0.0F}, 930U);
    put_wall(hall, {kLeft, 0.0F, kFront}, {0.0F, 0.0F, kWallZ - kFront}, 940U);
    put_wall(hall, {kRight, 0.0F, kWallZ}, {0.0F, 0.0F, kFront - kWallZ}, 950U);
    put_window_wall(hall);
    put_pipe_run(hall);
    put_cable_tray(hall);
    put_cabinet(hall);
}

}  // namespace obscura::stimuli::machine
