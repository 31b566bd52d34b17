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

vec3 crank_pin() {
    return {kCrankX + kThrow * std::cos(kCrankTurn), kAxis + kThrow * std::sin(kCrankTurn), 0.0F};
}

/// Where the crosshead's pin is: a rod's length from the crank's pin, on the axis.
float crosshead_x() {
    constexpr float kRod = 0.92F;
    const vec3 pin = crank_pin();
    const float up = pin.y - kAxis;
    return pin.x - std::sqrt(kRod * kRod - up * up);
}

void put_crosshead(Assembly& hall) {
    const float x = crosshead_x();
    for (const float up : {-1.0F, 1.0F}) {
        hall.put(Surface::kSteel, bevelled_box({0.66F, 0.034F, 0.11F}, 0.004F),
                 moved(-0.33F, kAxis + up * 0.125F, 0.0F), 35U);
        hall.put(Surface::kBrass, bevelled_box({0.2F, 0.02F, 0.10F}, 0.004F),
                 moved(x, kAxis + up * 0.097F, 0.0F), 36U);
    }
    // Pillars hold the guides at both ends.
    for (const float at_x : {-0.64F, -0.02F}) {
        for (const float z : {-0.075F, 0.075F}) {
            hall.put(Surface::kEnamel,
                     bevelled_box({0.055F, kAxis + 0.17F - kBedTop, 0.045F}, 0.008F),
                     moved(at_x, 0.5F * (kAxis + 0.17F + kBedTop), z), 37U, kGreen);
            put_bolt(hall, moved(at_x, kAxis + 0.17F, z), 0.014F, 38U);
        }
        hall.put(Surface::kEnamel, bevelled_box({0.10F, 0.03F, 0.27F}, 0.008F),
                 moved(at_x, kBedTop + 0.015F, 0.0F), 39U, kGreen);
        for (const float z : {-0.115F, 0.115F})
            put_bolt(hall, moved(at_x, kBedTop + 0.03F, z), 0.013F, 40U);
    }
    hall.put(Surface::kSteel, bevelled_box({0.15F, 0.17F, 0.075F}, 0.012F), moved(x, kAxis, 0.0F),
             41U);
    hall.put(Surface::kSteel,
             rod({kCylinderX + kCylinderHalf, kAxis, 0.0F}, {x, kAxis, 0.0F}, 0.03F, 24),
             glm::mat4(1.0F), 42U);
    put_oil_cup(hall, moved(-0.33F, kAxis + 0.142F, 0.0F), 0.036F);
}

/// The fork of the connecting rod lies on both sides of the crosshead; its big end is split.
void put_connecting_rod(Assembly& hall) {
    const vec3 pin = crank_pin();
    const vec3 from(crosshead_x(), kAxis, 0.0F);
    const float length = glm::length(pin - from);
    const float turn = std::atan2(pin.y - from.y, pin.x - from.x);
    const glm::mat4 place = moved(from) * about_z(turn);
    std::vector<vec2> shank{{0.0F, 0.16F}};
    for (int i = 0; i <= 8; ++i) {
        const float t = static_cast<float>(i) / 8.0F;
        shank.emplace_back(0.030F + 0.012F * std::sin(glm::pi<float>() * t),
                           0.16F + (length - 0.27F) * t);
    }
    shank.emplace_back(0.0F, length - 0.11F);
    hall.put(Surface::kSteel, revolve(shank, 24), place * lie_along_x(), 50U);
    for (const float z : {-0.06F, 0.06F}) {
        hall.put(Surface::kSteel, bevelled_box({0.24F, 0.075F, 0.032F}, 0.01F),
                 place * moved(0.075F, 0.0F, z), 51U);
    }
    hall.put(Surface::kSteel, bevelled_box({0.07F, 0.08F, 0.15F}, 0.014F),
             place * moved(0.175F, 0.0F, 0.0F), 52U);
    hall.put(Surface::kSteel, rod({0.0F, 0.0F, -0.1F}, {0.0F, 0.0F, 0.1F}, 0.028F, 20), place, 53U);
    for (const float part : {-1.0F, 1.0F}) {
        hall.put(part < 0.0F ? Surface::kSteel : Surface::kBrass,
                 bevelled_box({0.088F, 0.20F, 0.085F}, 0.012F),
                 place * moved(length + part * 0.046F, 0.0F, 0.0F), 54U);
    }
    hall.put(Surface::kSteel, bevelled_box({0.035F, 0.20F, 0.085F}, 0.01F),
             place * moved(length + 0.109F, 0.0F, 0.0F), 55U);
    for (const float y : {-0.075F, 0.075F}) {
        put_bolt(hall, place * moved(length + 0.126F, y, 0.0F) * lie_along_x(), 0.018F, 56U);
    }
    put_oil_cup(hall, place * moved(length + 0.046F, 0.098F, 0.0F), 0.028F);
}

void put_crank(Assembly& hall) {
    const vec3 pin = crank_pin();
    hall.put(Surface::kSteel, rod({kCrankX, kAxis, -0.98F}, {kCrankX, kAxis, -0.06F}, 0.055F, 32),
             glm::mat4(1.0F), 60U);
    hall.put(Surface::kSteel, rod({kCrankX, kAxis, 0.06F}, {kCrankX, kAxis, 0.60F}, 0.055F, 32),
             glm::mat4(1.0F), 61U);
    hall.put(Surface::kSteel, rod({pin.x, pin.y, -0.1F}, {pin.x, pin.y, 0.1F}, 0.042F, 28),
             glm::mat4(1.0F), 62U);
    // Two webs with counterweights.
    std::vector<vec2> web;
    for (int i = 0; i <= 12; ++i) {
        const float a = -glm::half_pi<float>() + glm::pi<float>() * static_cast<float>(i) / 12.0F;
        web.emplace_back(kThrow + 0.075F * std::cos(a), 0.075F * std::sin(a));
    }
    for (int i = 0; i <= 14; ++i) {
        const float a = 1.95F + (glm::two_pi<float>() - 3.9F) * static_cast<float>(i) / 14.0F;
        web.emplace_back(0.19F * std::cos(a), 0.19F * std::sin(a));
    }
    for (const float z : {-0.085F, 0.085F}) {
        hall.put(Surface::kCast, extrude(web, -0.027F, 0.027F, 0.5F),
                 moved(kCrankX, kAxis, z) * about_z(kCrankTurn), 63U);
    }
}

/// A pedestal bearing for a shaft along z.
void put_pedestal(Assembly& hall, float x, float z, float foot_y) {
    const float high = kAxis - foot_y;
    const glm::mat4 place = moved(x, foot_y, z);
    const std::array<vec2, 6> foot{{{-0.19F, 0.0F},
                                    {0.19F, 0.0F},
                                    {0.19F, 0.032F},
                                    {0.12F, 0.045F},
                                    {-0.12F, 0.045F},
                                    {-0.19F, 0.032F}}};
    hall.put(Surface::kEnamel, extrude(foot, -0.06F, 0.06F, 0.3F), place, 70U, kGreen);
    const std::array<vec2, 4> body{
        {{-0.12F, 0.04F}, {0.12F, 0.04F}, {0.105F, high}, {-0.105F, high}}};
    hall.put(Surface::kEnamel, extrude(body, -0.058F, 0.058F, 0.3F), place, 70U, kGreen);
    std::vector<vec2> cap{{0.105F, 0.004F}};
    for (int i = 0; i <= 14; ++i) {
        const float a = glm::pi<float>() * static_cast<float>(i) / 14.0F;
        cap.emplace_back(0.088F * std::cos(a), 0.025F + 0.075F * std::sin(a));
    }
    cap.emplace_back(-0.105F, 0.004F);
    hall.put(Surface::kEnamel, extrude(cap, -0.055F, 0.055F, 0.5F), place * moved(0.0F, high, 0.0F),
             71U, kGreen);
    const std::array<vec2, 4> shell{
        {{0.056F, -0.072F}, {0.078F, -0.072F}, {0.078F, 0.072F}, {0.056F, 0.072F}}};
    hall.put(Surface::kBrass, revolve(shell, 32), place * moved(0.0F, high, 0.0F) * lie_along_z(),
             72U);
    for (const float side : {-1.0F, 1.0F}) {
        for (const float along : {-0.03F, 0.03F}) {
            put_bolt(hall, place * moved(side * 0.155F, 0.034F, along), 0.016F, 73U);
        }
        hall.put(Surface::kEnamel, bevelled_box({0.05F, 0.05F, 0.09F}, 0.008F),
                 place * moved(side * 0.095F, high + 0.022F, 0.0F), 74U, kGreen);
        put_bolt(hall, place * moved(side * 0.097F, high + 0.047F, 0.0F), 0.016F, 75U);
    }
    put_oil_cup(hall, place * moved(0.0F, high + 0.097F, 0.0F), 0.042F);
}

void put_flywheel(Assembly& hall) {
    const glm::mat4 place = moved(kCrankX, kAxis, kFlywheelZ) * lie_along_z();
    constexpr float kRim = 0.72F;
    const std::array<vec2, 9> rim{{{kRim - 0.085F, -0.07F},
                                   {kRim - 0.012F, -0.075F},
                                   {kRim, -0.065F},
                                   {kRim, 0.065F},
                                   {kRim - 0.012F, 0.075F},
                                   {kRim - 0.085F, 0.07F},
                                   {kRim - 0.095F, 0.05F},
                                   {kRim - 0.095F, -0.05F},
                                   {kRim - 0.085F, -0.07F}}};
    hall.put(Surface::kEnamel, revolve(rim, 96), place, 80U, kRed);
    const std::array<vec2, 8> hub{{{0.0F, -0.10F},
                                   {0.11F, -0.10F},
                                   {0.125F, -0.085F},
                                   {0.135F, -0.03F},
                                   {0.135F, 0.03F},
                                   {0.125F, 0.085F},
                                   {0.11F, 0.10F},
                                   {0.0F, 0.10F}}};
    hall.put(Surface::kEnamel, revolve(hub, 40), place, 81U, kRed);
    // Six curved spokes of oval section.
    std::vector<vec2> oval;
    for (const vec2& point : circle(1.0F, 16))
        oval.emplace_back(0.030F * point.x, 0.043F * point.y);
    for (const glm::mat4& spot : around(6, 0.0F)) {
        std::vector<vec3> path;
        for (int i = 0; i <= 10; ++i) {
            const float t = static_cast<float>(i) / 10.0F;
            path.emplace_back(0.055F * std::sin(glm::pi<float>() * t), 0.0F, 0.11F + 0.53F * t);
        }
        hall.put(Surface::kEnamel, sweep(oval, frames_along(path, {1.0F, 0.0F, 0.0F})),
                 place * spot, 82U, kRed);
    }
}

/// A spindle with two balls on arms, driven by a small belt: it holds the speed.
void put_governor(Assembly& hall) {
    const glm::mat4 place = moved(-0.50F, kAxis + 0.17F, -0.20F);
    hall.put(Surface::kEnamel, bevelled_box({0.12F, 0.05F, 0.12F}, 0.01F),
             moved(-0.50F, kAxis + 0.12F, -0.20F), 90U, kGreen);
    hall.put(Surface::kEnamel,
             rod({-0.50F, kBedTop, -0.20F}, {-0.50F, kAxis + 0.10F, -0.20F}, 0.035F, 20),
             glm::mat4(1.0F), 91U, kGreen);
    put_flange(hall, Surface::kEnamel, moved(-0.50F, kBedTop, -0.20F), 0.085F, 0.02F, 4, 0.012F,
               kGreen);
    const std::array<vec2, 7> foot{{{0.0F, -0.03F},
                                    {0.045F, -0.03F},
                                    {0.04F, 0.02F},
                                    {0.018F, 0.06F},
                                    {0.014F, 0.12F},
                                    {0.012F, 0.40F},
                                    {0.0F, 0.41F}}};
    hall.put(Surface::kSteel, revolve(foot, 20), place, 92U);
    const std::array<vec2, 5> collar{
        {{0.0F, -0.02F}, {0.03F, -0.02F}, {0.03F, 0.02F}, {0.02F, 0.025F}, {0.0F, 0.025F}}};
    hall.put(Surface::kBrass, revolve(collar, 20), place * moved(0.0F, 0.37F, 0.0F), 93U);
    hall.put(Surface::kBrass, revolve(collar, 20), place * moved(0.0F, 0.16F, 0.0F), 94U);
    std::vector<vec2> ball;
    for (int i = 0; i <= 14; ++i) {
        const float a = glm::pi<float>() * (static_cast<float>(i) / 14.0F - 0.5F);
        ball.emplace_back(i == 0 || i == 14 ? 0.0F : 0.048F * std::cos(a), 0.048F * std::sin(a));
    }
    for (const float side : {-1.0F, 1.0F}) {
        const vec3 centre(side * 0.15F, 0.20F, 0.0F);
        hall.put(Surface::kBrass, revolve(ball, 24), place * moved(centre), 95U);
        hall.put(Surface::kSteel, rod({side * 0.02F, 0.37F, 0.0F}, centre, 0.009F), place, 96U);
        hall.put(Surface::kSteel,
                 rod({side * 0.025F, 0.16F, 0.0F}, {side * 0.10F, 0.256F, 0.0F}, 0.007F), place,
                 97U);
    }
}

}  // namespace

void build_engine(Assembly& hall) {
    put_crosshead(hall);
    put_connecting_rod(hall);
    put_crank(hall);
    put_pedestal(hall, kCrankX, -0.25F, kBedTop);
    put_pedestal(hall, kCrankX, 0.19F, kBedTop);
    put_pedestal(hall, kCrankX, -0.88F, kFoundationTop);
    put_flywheel(hall);
    put_governor(hall);
}

}  // namespace obscura::stimuli::machine
