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

constexpr float kCylinderR = 0.215F;

/// A cast frame with a working face, ribs on its sides and bolts through its foot.
void put_bed(Assembly& hall) {
    constexpr float kFrom = -1.52F;
    constexpr float kTo = 0.82F;
    constexpr float kHalf = 0.34F;
    const float length = kTo - kFrom;
    const float middle = 0.5F * (kFrom + kTo);
    const float foot = kFoundationTop;
    hall.put(Surface::kEnamel, bevelled_box({length + 0.1F, 0.035F, 2.0F * kHalf + 0.12F}, 0.008F),
             moved(middle, foot + 0.0175F, 0.0F), 1U, kGreen);
    hall.put(Surface::kEnamel, bevelled_box({length - 0.04F, 0.13F, 2.0F * kHalf - 0.10F}, 0.01F),
             moved(middle, foot + 0.095F, 0.0F), 2U, kGreen);
    hall.put(Surface::kEnamel, bevelled_box({length, 0.042F, 2.0F * kHalf}, 0.010F),
             moved(middle, kBedTop - 0.021F, 0.0F), 3U, kGreen);
    std::uint32_t seed = 100;
    for (const float side : {-1.0F, 1.0F}) {
        for (int i = 0; i <= 12; ++i) {
            const float x = kFrom + 0.08F + (length - 0.16F) * static_cast<float>(i) / 12.0F;
            const std::array<vec2, 4> web{
                {{0.0F, 0.0F}, {0.085F, 0.0F}, {0.05F, 0.13F}, {0.0F, 0.13F}}};
            hall.put(Surface::kEnamel, extrude(web, -0.009F, 0.009F),
                     moved(x, foot + 0.03F, side * (kHalf - 0.055F)) *
                         about_y(side > 0.0F ? -glm::half_pi<float>() : glm::half_pi<float>()),
                     seed++, kGreen);
            if (i < 12) {
                put_bolt(hall,
                         moved(x + 0.5F * (length - 0.16F) / 12.0F, foot + 0.035F,
                               side * (kHalf + 0.025F)),
                         0.017F, seed++);
            }
        }
    }
    // A drip tray's rim runs round the working face.
    for (const float side : {-1.0F, 1.0F}) {
        hall.put(Surface::kEnamel, bevelled_box({length, 0.02F, 0.016F}, 0.005F),
                 moved(middle, kBedTop + 0.010F, side * (kHalf - 0.008F)), seed++, kGreen);
    }
}

/// The lagging of the cylinder: strips of sheet held by two brass bands.
void put_lagging(Assembly& hall, const glm::mat4& axis) {
    const Mesh strip = bevelled_box({0.0435F, 2.0F * kCylinderHalf - 0.075F, 0.014F}, 0.004F);
    std::uint32_t seed = 200;
    for (const glm::mat4& spot : around(32, kCylinderR + 0.004F)) {
        hall.put(Surface::kWood, strip, axis * spot, seed, shade_of(seed, 0.35F));
        ++seed;
    }
    for (const float y : {-0.16F, 0.0F, 0.16F}) {
        const std::array<vec2, 4> band{{{kCylinderR + 0.006F, -0.014F},
                                        {kCylinderR + 0.015F, -0.014F},
                                        {kCylinderR + 0.015F, 0.014F},
                                        {kCylinderR + 0.006F, 0.014F}}};
        hall.put(Surface::kBrass, revolve(band, 48), axis * moved(0.0F, y, 0.0F), seed++);
    }
}

void put_cylinder(Assembly& hall) {
    const glm::mat4 axis = moved(kCylinderX, kAxis, 0.0F) * lie_along_x();
    const float h = kCylinderHalf;
    const float r = kCylinderR;
    const std::array<vec2, 10> barrel{{{0.0F, -h},
                                       {r + 0.045F, -h},
                                       {r + 0.045F, -h + 0.035F},
                                       {r + 0.005F, -h + 0.045F},
                                       {r - 0.006F, -h + 0.06F},
                                       {r - 0.006F, h - 0.06F},
                                       {r + 0.005F, h - 0.045F},
                                       {r + 0.045F, h - 0.035F},
                                       {r + 0.045F, h},
                                       {0.0F, h}}};
    hall.put(Surface::kEnamel, revolve(barrel, 64), axis, 5U, kGreen);
    put_lagging(hall, axis);
    for (const float end : {-1.0F, 1.0F}) {
        const glm::mat4 cover = axis * moved(0.0F, end * (h + 0.001F), 0.0F) *
                                about_x(end > 0.0F ? 0.0F : glm::pi<float>());
        const std::array<vec2, 9> plate{{{0.0F, 0.0F},
                                         {r + 0.043F, 0.0F},
                                         {r + 0.045F, 0.003F},
                                         {r + 0.045F, 0.024F},
                                         {r + 0.042F, 0.028F},
                                         {r - 0.03F, 0.030F},
                                         {r - 0.05F, 0.045F},
                                         {0.09F, 0.060F},
                                         {0.0F, 0.062F}}};
        hall.put(Surface::kEnamel, revolve(plate, 64), cover, 6U, kGreen);
        std::uint32_t seed = 260;
        for (const glm::mat4& spot : around(16, r + 0.018F, 0.1F)) {
            put_bolt(hall, cover * spot * moved(0.0F, 0.028F, 0.0F), 0.015F, seed++);
        }
    }
    // The gland round the piston rod.
    put_flange(hall, Surface::kBrass, axis * moved(0.0F, h + 0.06F, 0.0F), 0.075F, 0.022F, 4,
               0.011F);
    hall.put(Surface::kBrass, rod({0.0F, h + 0.08F, 0.0F}, {0.0F, h + 0.12F, 0.0F}, 0.045F, 24),
             axis, 7U);
    // Two saddles carry it.
    for (const float x : {-0.22F, 0.22F}) {
        const std::array<vec2, 8> saddle{{{-0.26F, 0.0F},
                                          {0.26F, 0.0F},
                                          {0.26F, 0.035F},
                                          {0.19F, 0.05F},
                                          {0.16F, 0.27F},
                                          {-0.16F, 0.27F},
                                          {-0.19F, 0.05F},
                                          {-0.26F, 0.035F}}};
        hall.put(Surface::kEnamel, extrude(saddle, -0.03F, 0.03F, 0.3F),
                 moved(kCylinderX + x, kBedTop, 0.0F) * about_y(glm::half_pi<float>()), 8U, kGreen);
        for (const float z : {-0.225F, 0.225F}) {
            put_bolt(hall, moved(kCylinderX + x, kBedTop + 0.035F, z), 0.019F, 9U);
        }
    }
}

/// The box of the slide valve on the cylinder's side, its lid held by studs.
void put_valve_chest(Assembly& hall) {
    const glm::mat4 place = moved(kCylinderX, kAxis + 0.03F, kCylinderR + 0.085F);
    hall.put(Surface::kEnamel, bevelled_box({0.40F, 0.27F, 0.17F}, 0.015F), place, 15U, kGreen);
    hall.put(Surface::kEnamel, bevelled_box({0.45F, 0.32F, 0.026F}, 0.007F),
             place * moved(0.0F, 0.0F, 0.085F), 16U, kGreen);
    hall.put(Surface::kEnamel, bevelled_box({0.45F, 0.32F, 0.022F}, 0.007F),
             place * moved(0.0F, 0.0F, 0.112F), 17U, kGreen);
    hall.put(Surface::kEnamel, bevelled_box({0.27F, 0.15F, 0.02F}, 0.008F),
             place * moved(0.0F, 0.0F, 0.128F), 18U, kGreen);
    hall.put(Surface::kBrass, bevelled_box({0.15F, 0.07F, 0.006F}, 0.002F),
             place * moved(0.0F, 0.0F, 0.140F), 19U);
    std::uint32_t seed = 300;
    for (int i = 0; i < 24; ++i) {
        // Round the lid's rim: 8 along each long side, 4 on each short one.
        const int on = i % 12;
        const float half = i < 12 ? 1.0F : -1.0F;
        const vec2 spot =
            on < 8 ? vec2(-0.2F + 0.4F * static_cast<float>(on) / 7.0F, 0.137F * half)
                   : vec2(0.2F * half, -0.082F + 0.164F * static_cast<float>(on - 8) / 3.0F);
        put_bolt(hall, place * moved(spot.x, spot.y, 0.123F) * about_x(glm::half_pi<float>()),
                 0.0125F, seed++);
    }
    // Its spindle and rod to the eccentric on the crankshaft.
    const float z = place[3].z;
    hall.put(Surface::kSteel,
             rod({kCylinderX + 0.2F, kAxis + 0.03F, z}, {-0.30F, kAxis + 0.03F, z}, 0.014F, 14),
             glm::mat4(1.0F), 30U);
    put_flange(hall, Surface::kBrass, moved(kCylinderX + 0.2F, kAxis + 0.03F, z) * lie_along_x(),
               0.045F, 0.018F, 3, 0.009F);
    hall.put(Surface::kSteel, bevelled_box({0.09F, 0.06F, 0.045F}, 0.012F),
             moved(-0.30F, kAxis + 0.03F, z), 31U);
    hall.put(Surface::kSteel,
             rod({-0.28F, kAxis + 0.03F, z}, {kCrankX - 0.1F, kAxis + 0.012F, z}, 0.017F, 14),
             glm::mat4(1.0F), 32U);
    const glm::mat4 eccentric = moved(kCrankX - 0.03F, kAxis + 0.01F, z) * lie_along_z();
    const std::array<vec2, 8> strap{{{0.0F, -0.022F},
                                     {0.095F, -0.022F},
                                     {0.12F, -0.024F},
                                     {0.126F, -0.018F},
                                     {0.126F, 0.018F},
                                     {0.12F, 0.024F},
                                     {0.095F, 0.022F},
                                     {0.0F, 0.022F}}};
    hall.put(Surface::kBrass, revolve(strap, 40), eccentric, 33U);
    for (const float side : {-1.0F, 1.0F}) {
        hall.put(Surface::kBrass, bevelled_box({0.05F, 0.05F, 0.04F}, 0.006F),
                 moved(kCrankX - 0.03F, kAxis + 0.01F + side * 0.142F, z), 34U);
    }
}

void put_steam_pipe(Assembly& hall) {
    // From the wall down to the valve chest.
    const float z = kCylinderR + 0.06F;
    const std::array<vec3, 5> path{{{kCylinderX, kAxis + 0.17F, z},
                                    {kCylinderX, 1.86F, z},
                                    {kCylinderX - 0.02F, 2.02F, z - 0.3F},
                                    {kCylinderX - 0.02F, 2.02F, -1.5F},
                                    {kCylinderX - 0.02F, 3.6F, -1.62F}}};
    hall.put(Surface::kEnamel, pipe(path, 0.18F, 0.055F, 28), glm::mat4(1.0F), 101U, kCream);
    put_flange(hall, Surface::kCast, moved(kCylinderX, kAxis + 0.165F, z), 0.11F, 0.022F, 8,
               0.013F);
    put_valve(hall, moved(kCylinderX, 1.32F, z), 0.055F);
    put_joint(hall, Surface::kCast, moved(kCylinderX - 0.02F, 2.02F, -0.75F) * lie_along_z(),
              0.055F);
    // A gauge on a siphon pipe.
    const std::array<vec3, 4> siphon{{{kCylinderX, 1.62F, z},
                                      {kCylinderX + 0.14F, 1.62F, z},
                                      {kCylinderX + 0.14F, 1.58F, z + 0.05F},
                                      {kCylinderX + 0.14F, 1.72F, z + 0.05F}}};
    hall.put(Surface::kCopper, pipe(siphon, 0.04F, 0.009F, 10), glm::mat4(1.0F), 102U);
    put_gauge(hall, moved(kCylinderX + 0.14F, 1.79F, z + 0.03F), 0.085F);
    // Drain cocks below the cylinder's ends.
    for (const float x : {-0.26F, 0.26F}) {
        const std::array<vec3, 4> drain{{{kCylinderX + x, kAxis - 0.2F, 0.10F},
                                         {kCylinderX + x, kAxis - 0.31F, 0.10F},
                                         {kCylinderX + x, kAxis - 0.34F, 0.30F},
                                         {kCylinderX + x, kFoundationTop + 0.04F, 0.42F}}};
        hall.put(Surface::kCopper, pipe(drain, 0.05F, 0.012F, 10), glm::mat4(1.0F), 103U);
        hall.put(Surface::kBrass, bevelled_box({0.035F, 0.05F, 0.035F}, 0.006F),
                 moved(kCylinderX + x, kAxis - 0.25F, 0.10F), 104U);
        hall.put(Surface::kBrass, bevelled_box({0.012F, 0.012F, 0.08F}, 0.004F),
                 moved(kCylinderX + x, kAxis - 0.245F, 0.15F), 105U);
    }
}

}  // namespace

void build_cylinder(Assembly& hall) {
    put_bed(hall);
    put_cylinder(hall);
    put_valve_chest(hall);
    put_steam_pipe(hall);
}

}  // namespace obscura::stimuli::machine
