// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "stimuli/scenes/machine/parts.h"

namespace obscura::stimuli::machine {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

constexpr float kBodyR = 0.205F;
constexpr float kFinR = 0.255F;
constexpr float kFrontZ = 0.36F;  ///< of the body; it reaches back to kBackZ
constexpr float kBackZ = -0.26F;

glm::mat4 shaft() {
    const float apart = 0.5F * kTooth * static_cast<float>(kWheelTeeth + kPinionTeeth);
    return moved(kCrankX + apart, kAxis, 0.0F);
}

/// The frame's section: thin fins all round, none where the feet and the terminal box are.
std::vector<vec2> finned_section() {
    std::vector<vec2> outline;
    constexpr int kFins = 52;
    for (int i = 0; i < kFins; ++i) {
        const float middle = glm::two_pi<float>() * (static_cast<float>(i) + 0.5F) / kFins;
        const float up = std::sin(middle);
        const float reach = std::abs(up) > 0.88F ? kBodyR + 0.006F : kFinR;
        const auto add = [&](float radius, float off_m) {
            const float a = middle + off_m / radius;
            outline.emplace_back(radius * std::cos(a), radius * std::sin(a));
        };
        add(kBodyR, -0.0055F);
        add(kBodyR + 0.004F, -0.0038F);
        add(reach, -0.0022F);
        add(reach, 0.0022F);
        add(kBodyR + 0.004F, 0.0038F);
        add(kBodyR, 0.0055F);
    }
    return outline;
}

void put_body(Assembly& hall) {
    std::vector<ProfileFrame> frames;
    for (int i = 0; i <= 8; ++i) {
        const float t = static_cast<float>(i) / 8.0F;
        frames.push_back({{0.0F, 0.0F, kBackZ + 0.05F + (kFrontZ - kBackZ - 0.10F) * t}});
    }
    SweepOptions options;
    options.crease_rad = 0.5F;
    hall.put(Surface::kEnamel, sweep(finned_section(), frames, options), shaft(), 501U, kBlueGrey);
    // End shields with ribs, bolted on.
    for (const float end : {-1.0F, 1.0F}) {
        const float z = end > 0.0F ? kFrontZ - 0.05F : kBackZ + 0.05F;
        const glm::mat4 place =
            shaft() * moved(0.0F, 0.0F, z) * about_x(end * glm::half_pi<float>());
        const std::array<vec2, 9> shield{{{0.0F, 0.0F},
                                          {kBodyR + 0.018F, 0.0F},
                                          {kBodyR + 0.022F, 0.006F},
                                          {kBodyR + 0.022F, 0.028F},
                                          {kBodyR + 0.01F, 0.034F},
                                          {0.12F, 0.05F},
                                          {0.085F, 0.075F},
                                          {0.075F, 0.09F},
                                          {0.0F, 0.092F}}};
        hall.put(Surface::kEnamel, revolve(shield, 56), place, 502U, kBlueGrey);
        for (const glm::mat4& spot : around(10, 0.0F)) {
            const std::array<vec2, 4> rib{
                {{0.07F, 0.03F}, {0.19F, 0.03F}, {0.185F, 0.045F}, {0.08F, 0.088F}}};
            hall.put(Surface::kEnamel, extrude(rib, -0.005F, 0.005F, 0.3F), place * spot, 503U,
                     kBlueGrey);
        }
        std::uint32_t seed = 510;
        const Mesh one = bolt(0.011F);
        for (const glm::mat4& spot : around(8, kBodyR - 0.005F, 0.2F)) {
            hall.put(Surface::kSteel, one, place * spot * moved(0.0F, 0.033F, 0.0F), seed++);
        }
    }
}

/// A cowl over the fan: sheet with a guard of rings and bars.
void put_cowl(Assembly& hall) {
    const glm::mat4 place =
        shaft() * moved(0.0F, 0.0F, kBackZ - 0.02F) * about_x(-glm::half_pi<float>());
    const std::array<vec2, 8> sheet{{{0.236F, 0.10F},
                                     {0.246F, -0.06F},
                                     {0.252F, -0.06F},
                                     {0.252F, 0.10F},
                                     {0.235F, 0.125F},
                                     {0.20F, 0.132F},
                                     {0.198F, 0.126F},
                                     {0.198F, 0.05F}}};
    hall.put(Surface::kEnamel, revolve(sheet, 56), place, 520U, kBlueGrey);
    const std::array<vec2, 4> inside{
        {{0.0F, 0.055F}, {0.238F, 0.055F}, {0.238F, 0.06F}, {0.0F, 0.06F}}};
    hall.put(Surface::kDark, revolve(inside, 32), place, 521U);
    for (int i = 1; i <= 8; ++i) {
        hall.put(Surface::kZinc, ring(0.024F * static_cast<float>(i), 0.0028F, 40, 6),
                 place * moved(0.0F, 0.13F, 0.0F), 522U);
    }
    for (const glm::mat4& spot : around(4, 0.0F)) {
        hall.put(Surface::kZinc, rod({0.0F, 0.1255F, 0.0F}, {0.0F, 0.1255F, 0.205F}, 0.003F, 6),
                 place * spot, 523U);
    }
}

void put_feet(Assembly& hall) {
    const float low = kFoundationTop;
    hall.put(Surface::kEnamel, bevelled_box({0.50F, 0.16F, 0.60F}, 0.012F),
             shaft() * moved(0.0F, low + 0.08F - kAxis, 0.05F), 530U, kGreen);
    hall.put(Surface::kEnamel, bevelled_box({0.58F, 0.03F, 0.66F}, 0.008F),
             shaft() * moved(0.0F, low + 0.015F - kAxis, 0.05F), 531U, kGreen);
    for (const float x : {-1.0F, 1.0F}) {
        for (const float z : {-0.12F, 0.22F}) {
            const std::array<vec2, 5> foot{{{0.05F, -0.28F},
                                            {0.23F, -0.28F},
                                            {0.23F, -0.255F},
                                            {0.15F, -0.235F},
                                            {0.09F, -0.16F}}};
            hall.put(
                Surface::kEnamel, extrude(foot, -0.045F, 0.045F, 0.4F),
                shaft() * moved(0.0F, 0.0F, z) * glm::scale(glm::mat4(1.0F), vec3(x, 1.0F, 1.0F)),
                532U, kBlueGrey);
            hall.put(Surface::kSteel, bolt(0.018F), shaft() * moved(x * 0.195F, -0.255F, z), 533U);
            hall.put(Surface::kSteel, bolt(0.018F),
                     shaft() * moved(x * 0.270F, low + 0.03F - kAxis, z), 534U);
        }
    }
    hall.put(Surface::kEnamel, bevelled_box({0.50F, 0.04F, 0.5F}, 0.008F),
             shaft() * moved(0.0F, low + 0.18F - kAxis, 0.05F), 535U, kGreen);
}

void put_terminals(Assembly& hall) {
    const glm::mat4 place = shaft() * moved(0.0F, kBodyR + 0.055F, 0.06F);
    hall.put(Surface::kEnamel, bevelled_box({0.18F, 0.12F, 0.24F}, 0.012F), place, 540U, kBlueGrey);
    hall.put(Surface::kEnamel, bevelled_box({0.195F, 0.016F, 0.255F}, 0.006F),
             place * moved(0.0F, 0.066F, 0.0F), 541U, kBlueGrey);
    for (const float x : {-0.083F, 0.083F}) {
        for (const float z : {-0.113F, 0.113F}) {
            hall.put(Surface::kSteel, bolt(0.008F), place * moved(x, 0.074F, z), 542U);
        }
    }
    // Three glands and cables that drop to the floor and run to the cabinet.
    for (int i = 0; i < 3; ++i) {
        const float z = 0.07F - 0.07F * static_cast<float>(i);
        const glm::mat4 gland = place * moved(0.09F, -0.01F, z) * lie_along_x();
        const std::array<vec2, 6> nut{{{0.0F, 0.0F},
                                       {0.025F, 0.0F},
                                       {0.025F, 0.022F},
                                       {0.019F, 0.026F},
                                       {0.017F, 0.045F},
                                       {0.0F, 0.045F}}};
        hall.put(Surface::kBrass, revolve(nut, 6, 0.3F), gland, 543U);
        const vec3 from = vec3(place[3]) + vec3(0.13F, -0.01F, z);
        // Down by its own weight, over the foundation's edge and along the floor, no two alike.
        const float n = static_cast<float>(i);
        const float block = kFoundationTop + 0.014F;
        const float edge = 1.755F + 0.004F * n;
        const std::array<vec3, 14> run{
            {from - vec3(0.035F, 0.0F, 0.0F),
             from + vec3(0.030F, -0.002F, 0.0F),
             from + vec3(0.105F + 0.012F * n, -0.045F, -0.006F * n),
             from + vec3(0.150F + 0.020F * n, -0.165F, -0.012F),
             from + vec3(0.150F + 0.026F * n, -0.400F, -0.030F - 0.01F * n),
             {from.x + 0.125F + 0.032F * n, block + 0.12F, from.z - 0.06F},
             {from.x + 0.155F + 0.030F * n, block + 0.012F, from.z - 0.12F},
             {edge - 0.050F, block + 0.004F, from.z - 0.21F - 0.02F * n},
             {edge + 0.012F, block - 0.010F, from.z - 0.27F - 0.03F * n},
             {edge + 0.055F, 0.060F, from.z - 0.33F - 0.03F * n},
             {edge + 0.120F, 0.015F, from.z - 0.45F - 0.05F * n},
             {1.92F + 0.05F * n, 0.014F, -0.93F + 0.04F * n},
             {1.78F + 0.08F * n, 0.014F, -1.25F},
             {1.85F + 0.06F * n, 0.050F, -1.53F}}};
        hall.put(Surface::kRubber, slack_cable(run, 0.0125F, 10), glm::mat4(1.0F), 544U);
        const std::array<vec2, 5> collar{
            {{0.0F, 0.0F}, {0.024F, 0.0F}, {0.024F, 0.020F}, {0.017F, 0.034F}, {0.0F, 0.034F}}};
        hall.put(Surface::kBrass, revolve(collar, 6, 0.3F),
                 moved(1.85F + 0.06F * n, 0.050F, -1.492F) * lie_along_z(), 546U);
    }
    // Where they go into the cabinet's plinth.
    hall.put(Surface::kZinc, bevelled_box({0.20F, 0.075F, 0.012F}, 0.003F),
             moved(1.91F, 0.050F, -1.495F), 547U);
    hall.put(Surface::kBrass, bevelled_box({0.004F, 0.05F, 0.10F}, 0.001F),
             place * moved(0.092F, 0.0F, 0.0F) * moved(0.0F, 0.03F, 0.0F), 545U);
}

}  // namespace

void build_generator(Assembly& hall) {
    put_body(hall);
    put_cowl(hall);
    put_feet(hall);
    put_terminals(hall);
}

}  // namespace obscura::stimuli::machine
