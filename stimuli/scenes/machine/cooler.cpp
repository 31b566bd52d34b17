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

const vec3 kPlace(-0.45F, 0.0F, -1.30F);
constexpr float kHalfWidth = 0.42F;  ///< of its width
constexpr float kLow = 0.30F;        ///< of the fins
constexpr float kHigh = 1.18F;

/// Thin plates on a row of tubes that turn back at their ends.
void put_core(Assembly& hall) {
    const Mesh plate = bevelled_box({0.0034F, kHigh - kLow, 0.16F}, 0.0F);
    // No finer than three pixels apart in the farthest view, where they would beat with its grid.
    constexpr int kPlates = 40;
    for (int i = 0; i < kPlates; ++i) {
        const float x = -kHalfWidth + 0.03F +
                        (2.0F * kHalfWidth - 0.06F) * (static_cast<float>(i) + 0.5F) / kPlates;
        const auto seed = 600U + static_cast<std::uint32_t>(i);
        hall.put(Surface::kZinc, plate, moved(kPlace + vec3(x, 0.5F * (kLow + kHigh), 0.0F)), seed,
                 shade_of(seed, 0.10F));
    }
    constexpr int kTubes = 10;
    for (int i = 0; i < kTubes; ++i) {
        const float y = kLow + (kHigh - kLow) * (static_cast<float>(i) + 0.5F) / kTubes;
        for (const float z : {-0.045F, 0.045F}) {
            hall.put(Surface::kCopper,
                     rod({-kHalfWidth - 0.02F, y, z}, {kHalfWidth + 0.02F, y, z}, 0.013F, 14),
                     moved(kPlace), 700U);
        }
        if (i + 1 == kTubes) continue;
        const float end = i % 2 == 0 ? 1.0F : -1.0F;
        const float step = (kHigh - kLow) / kTubes;
        const std::array<vec3, 4> turn{{{end * (kHalfWidth + 0.018F), y, 0.045F},
                                        {end * (kHalfWidth + 0.075F), y, 0.045F},
                                        {end * (kHalfWidth + 0.075F), y + step, 0.045F},
                                        {end * (kHalfWidth + 0.018F), y + step, 0.045F}}};
        hall.put(Surface::kCopper, pipe(turn, 0.045F, 0.013F, 12), moved(kPlace), 701U);
    }
}

void put_frame(Assembly& hall) {
    for (const float x : {-1.0F, 1.0F}) {
        hall.put(Surface::kEnamel, bevelled_box({0.025F, kHigh + 0.05F - 0.0F, 0.20F}, 0.004F),
                 moved(kPlace + vec3(x * kHalfWidth, 0.5F * (kHigh + 0.05F), 0.0F)), 710U,
                 kBlueGrey);
        hall.put(Surface::kEnamel, bevelled_box({0.11F, 0.02F, 0.30F}, 0.004F),
                 moved(kPlace + vec3(x * kHalfWidth, 0.01F, 0.0F)), 711U, kBlueGrey);
        for (const float z : {-0.12F, 0.12F}) {
            hall.put(Surface::kSteel, bolt(0.014F), moved(kPlace + vec3(x * kHalfWidth, 0.02F, z)),
                     712U);
        }
    }
    for (const float y : {kLow - 0.03F, kHigh + 0.03F}) {
        hall.put(Surface::kEnamel, bevelled_box({2.0F * kHalfWidth + 0.03F, 0.03F, 0.194F}, 0.004F),
                 moved(kPlace + vec3(0.0F, y, 0.0F)), 713U, kBlueGrey);
    }
}

/// A small centrifugal pump beside it and the oil pipes to the engine's bearings.
void put_pump(Assembly& hall) {
    const vec3 at(-1.35F, 0.0F, -1.30F);
    hall.put(Surface::kConcrete, bevelled_box({0.5F, 0.14F, 0.4F}, 0.01F),
             moved(at + vec3(0.0F, 0.07F, 0.0F)), 720U);
    const glm::mat4 axis = moved(at + vec3(0.0F, 0.32F, 0.0F)) * lie_along_z();
    const std::array<vec2, 10> volute{{{0.0F, -0.07F},
                                       {0.08F, -0.07F},
                                       {0.10F, -0.05F},
                                       {0.145F, -0.045F},
                                       {0.155F, -0.02F},
                                       {0.155F, 0.02F},
                                       {0.145F, 0.045F},
                                       {0.10F, 0.05F},
                                       {0.07F, 0.075F},
                                       {0.0F, 0.075F}}};
    hall.put(Surface::kEnamel, revolve(volute, 40), axis, 721U, kBlueGrey);
    put_flange(hall, Surface::kCast, axis * moved(0.0F, 0.07F, 0.0F), 0.075F, 0.016F, 6, 0.010F);
    const std::array<vec2, 4> foot{
        {{-0.12F, 0.0F}, {0.12F, 0.0F}, {0.06F, 0.14F}, {-0.06F, 0.14F}}};
    hall.put(Surface::kEnamel, extrude(foot, -0.05F, 0.05F), moved(at + vec3(0.0F, 0.14F, 0.0F)),
             722U, kBlueGrey);
    const std::array<vec3, 4> out{{{at.x + 0.13F, 0.34F, at.z},
                                   {at.x + 0.13F, 0.64F, at.z},
                                   {at.x + 0.13F, 0.9F, at.z + 0.045F},
                                   {kPlace.x - kHalfWidth - 0.02F, 0.9F, at.z + 0.045F}}};
    hall.put(Surface::kCopper, pipe(out, 0.09F, 0.024F, 16), glm::mat4(1.0F), 723U);
    put_valve(hall, moved(at.x + 0.13F, 0.62F, at.z), 0.026F);
    // From the cooler's top along the wall and down to the bearings.
    const std::array<vec3, 5> back{{{kPlace.x + kHalfWidth, 1.10F, kPlace.z + 0.045F},
                                    {kPlace.x + kHalfWidth + 0.16F, 1.10F, kPlace.z + 0.045F},
                                    {kPlace.x + kHalfWidth + 0.16F, 1.52F, kPlace.z + 0.045F},
                                    {kCrankX, 1.62F, kPlace.z + 0.045F},
                                    {kCrankX, 1.62F, -1.05F}}};
    hall.put(Surface::kCopper, pipe(back, 0.10F, 0.018F, 14), glm::mat4(1.0F), 724U);
    const std::array<vec3, 4> drop{{{kCrankX, 1.62F, -1.06F},
                                    {kCrankX, 1.62F, -0.89F},
                                    {kCrankX, 1.45F, -0.88F},
                                    {kCrankX, kAxis + 0.15F, -0.88F}}};
    hall.put(Surface::kCopper, pipe(drop, 0.08F, 0.011F, 12), glm::mat4(1.0F), 725U);
}

}  // namespace

void build_cooler(Assembly& hall) {
    put_core(hall);
    put_frame(hall);
    put_pump(hall);
}

}  // namespace obscura::stimuli::machine
