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

/// Posts with balls that two rails run through.
void put_railing(Assembly& hall) {
    const std::array<vec2, 9> post{{{0.0F, 0.0F},
                                    {0.06F, 0.0F},
                                    {0.06F, 0.015F},
                                    {0.028F, 0.03F},
                                    {0.020F, 0.06F},
                                    {0.017F, 0.5F},
                                    {0.017F, 0.98F},
                                    {0.012F, 1.0F},
                                    {0.0F, 1.0F}}};
    std::vector<vec2> ball;
    for (int i = 0; i <= 10; ++i) {
        const float a = glm::pi<float>() * (static_cast<float>(i) / 10.0F - 0.5F);
        ball.emplace_back(i == 0 || i == 10 ? 0.0F : 0.036F * std::cos(a), 0.036F * std::sin(a));
    }
    const float z = -1.12F;
    for (const float x : {-0.15F, 0.62F, 1.40F, 2.1F}) {
        hall.put(Surface::kSteel, revolve(post, 20), moved(x, 0.0F, z), 1001U);
        for (const float y : {0.52F, 1.0F})
            hall.put(Surface::kSteel, revolve(ball, 18), moved(x, y, z), 1002U);
    }
    for (const float y : {0.52F, 1.0F}) {
        hall.put(Surface::kSteel, rod({-0.15F, y, z}, {2.1F, y, z}, 0.015F, 14), glm::mat4(1.0F),
                 1003U);
    }
}

Mesh chain_of(float length) {
    std::vector<vec3> loop;
    for (int i = 0; i < 14; ++i) {
        const float a = glm::two_pi<float>() * static_cast<float>(i) / 14.0F;
        loop.emplace_back(0.017F * std::cos(a), 0.030F * std::sin(a), 0.0F);
    }
    SweepOptions closed;
    closed.closed_path = true;
    const Mesh link =
        sweep(circle(0.006F, 7), frames_along(loop, {0.0F, 0.0F, 1.0F}, true), closed);
    Mesh whole;
    constexpr float kStep = 0.047F;
    const int links = static_cast<int>(length / kStep);
    for (int i = 0; i < links; ++i) {
        Placement placement;
        placement.transform = moved(0.0F, -kStep * (static_cast<float>(i) + 0.5F), 0.0F) *
                              about_y((i & 1) != 0 ? glm::half_pi<float>() : 0.0F);
        append(whole, link, placement);
    }
    return whole;
}

/// A chain hoist above the crank with its hook.
void put_hoist(Assembly& hall) {
    const vec3 top(0.10F, 3.4F, -0.35F);
    hall.put(Surface::kSteel, chain_of(1.42F), moved(top), 1010U, vec3(0.5F));
    const float low = top.y - 1.42F;
    hall.put(Surface::kEnamel, bevelled_box({0.10F, 0.14F, 0.07F}, 0.02F),
             moved(top.x, low - 0.06F, top.z), 1011U, kYellow);
    hall.put(Surface::kSteel, bolt(0.02F),
             moved(top.x, low - 0.06F, top.z + 0.035F) * lie_along_z(), 1012U);
    std::vector<vec3> hook{{0.0F, 0.0F, 0.0F}, {0.0F, -0.05F, 0.0F}};
    // From the shank round below, to a tip that looks up again.
    for (int i = 1; i <= 16; ++i) {
        const float a = 4.9F * static_cast<float>(i) / 16.0F;
        hook.emplace_back(0.045F * std::sin(a), -0.095F + 0.045F * std::cos(a), 0.0F);
    }
    hall.put(Surface::kSteel, sweep(circle(0.012F, 12), frames_along(hook, {0.0F, 0.0F, 1.0F})),
             moved(top.x, low - 0.12F, top.z), 1013U, vec3(0.6F));
    // The hand chain hangs in a loop: two lengths, and what joins them below.
    hall.put(Surface::kSteel, chain_of(2.2F),
             moved(top + vec3(-0.16F, 0.0F, 0.05F)) * glm::scale(glm::mat4(1.0F), vec3(0.7F)),
             1014U, vec3(0.5F));
    hall.put(Surface::kSteel, chain_of(2.2F),
             moved(top + vec3(-0.23F, 0.0F, 0.05F)) * glm::scale(glm::mat4(1.0F), vec3(0.7F)),
             1015U, vec3(0.5F));
    std::vector<vec3> bend{{0.035F, 0.07F, 0.0F}};
    for (int i = 0; i <= 10; ++i) {
        const float a = glm::pi<float>() * static_cast<float>(i) / 10.0F;
        bend.emplace_back(0.035F * std::cos(a), -0.05F * std::sin(a), 0.0F);
    }
    bend.emplace_back(-0.035F, 0.07F, 0.0F);
    hall.put(Surface::kSteel, sweep(circle(0.006F, 8), frames_along(bend, {0.0F, 0.0F, 1.0F})),
             moved(top + vec3(-0.195F, -0.7F * 2.2F + 0.01F, 0.05F)), 1016U, vec3(0.5F));
}

/// A double-ended spanner lying flat, its length along x.
Mesh spanner(float length) {
    const float thick = 0.022F * length + 0.003F;
    Mesh whole = bevelled_box({0.70F * length, thick, 0.055F * length}, 0.2F * thick);
    for (const float end : {-1.0F, 1.0F}) {
        std::vector<vec3> jaw;
        for (int i = 0; i <= 14; ++i) {
            const float a = 0.75F + (glm::two_pi<float>() - 1.5F) * static_cast<float>(i) / 14.0F;
            jaw.emplace_back(end * (0.42F * length + 0.06F * length * std::cos(a)), 0.0F,
                             0.06F * length * std::sin(a));
        }
        const float w = 0.024F * length;
        const float h = 0.62F * thick;
        const std::array<vec2, 4> section{{{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
        append(whole, sweep(section, frames_along(jaw, {0.0F, 1.0F, 0.0F})));
    }
    Mesh lying;
    append(lying, whole, {.transform = moved(0.0F, 0.5F * thick, 0.0F)});
    return lying;
}

void put_oil_can(Assembly& hall, const glm::mat4& place) {
    const std::array<vec2, 10> can{{{0.0F, 0.0F},
                                    {0.058F, 0.0F},
                                    {0.062F, 0.006F},
                                    {0.060F, 0.012F},
                                    {0.058F, 0.09F},
                                    {0.062F, 0.096F},
                                    {0.056F, 0.104F},
                                    {0.02F, 0.15F},
                                    {0.014F, 0.17F},
                                    {0.0F, 0.17F}}};
    hall.put(Surface::kCopper, revolve(can, 32), place, 1020U);
    const std::array<vec3, 4> spout{
        {{0.0F, 0.16F, 0.0F}, {0.015F, 0.22F, 0.0F}, {0.07F, 0.29F, 0.0F}, {0.17F, 0.33F, 0.0F}}};
    hall.put(Surface::kCopper, pipe(spout, 0.05F, 0.007F, 10), place, 1021U);
    const std::array<vec3, 4> grip{{{-0.05F, 0.02F, 0.0F},
                                    {-0.105F, 0.04F, 0.0F},
                                    {-0.10F, 0.13F, 0.0F},
                                    {-0.03F, 0.135F, 0.0F}}};
    hall.put(Surface::kCopper, pipe(grip, 0.03F, 0.006F, 8), place, 1022U);
}

void put_bucket(Assembly& hall, const glm::mat4& place, const vec3& tint) {
    const std::array<vec2, 9> pail{{{0.0F, 0.0F},
                                    {0.105F, 0.0F},
                                    {0.108F, 0.012F},
                                    {0.142F, 0.27F},
                                    {0.150F, 0.275F},
                                    {0.150F, 0.287F},
                                    {0.140F, 0.285F},
                                    {0.106F, 0.03F},
                                    {0.0F, 0.025F}}};
    hall.put(Surface::kEnamel, revolve(pail, 36), place, 1030U, tint);
    // Two ears riveted on below the rim, outside; the bail hooks into them and lies on the rim.
    constexpr float kEar = 0.157F;
    for (const float x : {-1.0F, 1.0F}) {
        hall.put(Surface::kZinc, bevelled_box({0.008F, 0.034F, 0.030F}, 0.002F),
                 place * moved(x * 0.1475F, 0.252F, 0.0F) * about_z(-x * 0.13F), 1031U);
        hall.put(Surface::kZinc,
                 rod({x * 0.144F, 0.252F, 0.0F}, {x * (kEar + 0.004F), 0.252F, 0.0F}, 0.0045F, 8),
                 place, 1031U);
    }
    std::vector<vec3> bail;
    for (int i = 0; i <= 24; ++i) {
        const float a = glm::pi<float>() * static_cast<float>(i) / 24.0F;
        const float s = std::sin(a);
        bail.emplace_back(kEar * std::cos(a), 0.252F + 0.048F * std::min(1.0F, 2.2F * s),
                          0.158F * s);
    }
    hall.put(Surface::kZinc, sweep(circle(0.0036F, 8), frames_along(bail, {0.0F, 1.0F, 0.0F})),
             place, 1031U);
}

/// A board on the wall with tools on nails.
void put_tool_board(Assembly& hall) {
    const glm::mat4 place = moved(-2.25F, 1.0F, kWallZ + 0.035F);
    for (int i = 0; i < 5; ++i) {
        const auto seed = 1040U + static_cast<std::uint32_t>(i);
        hall.put(Surface::kWood, bevelled_box({0.158F, 0.66F, 0.02F}, 0.004F),
                 place * moved(-0.32F + 0.16F * static_cast<float>(i), 0.0F, 0.0F), seed,
                 shade_of(seed, 0.35F));
    }
    for (int i = 0; i < 7; ++i) {
        const float length = 0.42F - 0.035F * static_cast<float>(i);
        const float x = -0.34F + 0.11F * static_cast<float>(i);
        hall.put(Surface::kSteel, spanner(length),
                 place * moved(x, 0.22F - 0.5F * length, 0.012F) * about_x(glm::half_pi<float>()) *
                     about_y(glm::half_pi<float>()),
                 1050U, vec3(0.7F));
        hall.put(Surface::kSteel, rod({x, 0.20F, 0.0F}, {x, 0.215F, 0.05F}, 0.004F, 6), place,
                 1051U);
    }
}

/// A slatted crate, 0.5 m x 0.46 m x 0.62 m, on the origin.
void put_crate(Assembly& hall, const glm::mat4& place, std::uint32_t seed) {
    const auto board = [&](const glm::vec3& size, const glm::mat4& at) {
        ++seed;
        hall.put(Surface::kWood, bevelled_box(size, 0.003F), place * at, seed,
                 shade_of(seed, 0.3F));
    };
    for (int i = 0; i < 4; ++i) {
        const float y = 0.06F + 0.11F * static_cast<float>(i);
        for (const float side : {-1.0F, 1.0F}) {
            board({0.102F, 0.60F, 0.018F},
                  moved(side * 0.24F, y, 0.0F) * lie_along_z() * about_y(glm::half_pi<float>()));
            board({0.102F, 0.48F, 0.018F},
                  moved(0.0F, y, side * 0.30F) * about_z(glm::half_pi<float>()));
        }
        board({0.125F, 0.62F, 0.016F},
              moved(-0.19F + 0.127F * static_cast<float>(i), 0.458F, 0.0F) * lie_along_z());
    }
    for (const float x : {-0.21F, 0.21F}) {
        for (const float z : {-0.27F, 0.27F}) board({0.04F, 0.45F, 0.04F}, moved(x, 0.225F, z));
    }
}

/// Drums and crates along the left wall.
void put_stores(Assembly& hall) {
    const std::array<vec2, 13> drum{{{0.0F, 0.0F},
                                     {0.26F, 0.0F},
                                     {0.285F, 0.005F},
                                     {0.285F, 0.02F},
                                     {0.28F, 0.03F},
                                     {0.28F, 0.28F},
                                     {0.29F, 0.295F},
                                     {0.28F, 0.31F},
                                     {0.28F, 0.57F},
                                     {0.29F, 0.585F},
                                     {0.28F, 0.60F},
                                     {0.28F, 0.855F},
                                     {0.285F, 0.86F}}};
    const std::array<vec2, 4> lid{
        {{0.285F, 0.86F}, {0.285F, 0.88F}, {0.268F, 0.88F}, {0.266F, 0.862F}}};
    const std::array<vec2, 2> top{{{0.266F, 0.862F}, {0.0F, 0.862F}}};
    std::uint32_t seed = 1060;
    for (const vec3& foot :
         {vec3(-2.82F, 0.0F, -1.5F), vec3(-2.85F, 0.0F, -0.85F), vec3(-2.80F, 0.0F, -0.2F)}) {
        const vec3 tint = seed % 3 == 0 ? kBlueGrey : (seed % 3 == 1 ? kRed : kGreen);
        const glm::mat4 place = moved(foot) * about_y(static_cast<float>(seed));
        hall.put(Surface::kEnamel, revolve(drum, 48), place, seed, tint);
        hall.put(Surface::kEnamel, revolve(lid, 48), place, seed, tint);
        hall.put(Surface::kEnamel, revolve(top, 48), place, seed, tint);
        hall.put(Surface::kZinc, bolt(0.03F), place * moved(0.17F, 0.858F, 0.0F), seed);
        ++seed;
    }
    for (const vec3& foot : {vec3(-2.85F, 0.0F, 0.55F), vec3(-2.78F, 0.46F, 0.58F)}) {
        put_crate(hall, moved(foot) * about_y(0.1F * static_cast<float>(seed % 3) - 0.08F), seed);
        seed += 40;
    }
}

}  // namespace

void build_clutter(Assembly& hall) {
    put_railing(hall);
    put_hoist(hall);
    put_tool_board(hall);
    put_stores(hall);
    put_oil_can(hall, moved(-0.10F, kBedTop, 0.22F) * about_y(0.5F));
    put_bucket(hall, moved(-1.92F, 0.0F, -1.58F) * about_y(1.4F), kRed);
    hall.put(Surface::kSteel, spanner(0.38F),
             moved(-0.28F, kBedTop + 0.001F, 0.27F) * about_y(0.25F), 1070U);
}

}  // namespace obscura::stimuli::machine
