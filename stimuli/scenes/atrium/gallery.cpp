// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/atrium/parts.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

constexpr float kParapetFoot = kLowerTop + 0.26F;  // top of the string course
constexpr float kRailTop = 6.5F;
constexpr float kArchX = 0.86F;  // middle of an arch from the bay's middle
constexpr float kRadius = 0.64F;
constexpr float kUpperHalf = 0.22F;  // half the thickness of the upper wall

std::vector<vec2> main_cornice() {
    return {{0.0F, 0.0F},    {0.04F, 0.0F},  {0.05F, 0.06F},  {0.05F, 0.16F},  {0.07F, 0.18F},
            {0.10F, 0.21F},  {0.12F, 0.25F}, {0.25F, 0.26F},  {0.26F, 0.265F}, {0.26F, 0.34F},
            {0.27F, 0.345F}, {0.30F, 0.37F}, {0.325F, 0.42F}, {0.33F, 0.455F}, {0.0F, 0.46F}};
}

Mesh baluster() {
    const std::vector<vec2> profile{{0.055F, 0.0F},  {0.057F, 0.03F}, {0.036F, 0.06F},
                                    {0.048F, 0.12F}, {0.067F, 0.2F},  {0.064F, 0.28F},
                                    {0.036F, 0.42F}, {0.031F, 0.53F}, {0.046F, 0.565F},
                                    {0.036F, 0.59F}, {0.052F, 0.62F}, {0.055F, 0.66F}};
    return revolve(profile, 16);
}

/// Square pier from the parapet to the springing with a moulded head, at each bay line.
void put_pier(Site& site, const glm::mat4& place, std::uint32_t seed) {
    const float height = kUpperSpringing - kParapetFoot;
    site.put(Surface::kAshlar, bevelled_box({0.5F, height - 0.16F, 0.46F}, 0.02F),
             place * at(0.0F, kParapetFoot + 0.5F * (height - 0.16F), 0.0F), seed);
    site.put(Surface::kStone, bevelled_box({0.58F, 0.09F, 0.54F}, 0.02F),
             place * at(0.0F, kUpperSpringing - 0.205F, 0.0F), seed);
    site.put(Surface::kStone, bevelled_box({0.64F, 0.17F, 0.6F}, 0.025F),
             place * at(0.0F, kUpperSpringing - 0.085F, 0.0F), seed + 1U);
    site.put(Surface::kStone, bevelled_box({0.6F, 0.2F, 0.56F}, 0.025F),
             place * at(0.0F, kParapetFoot + 0.1F, 0.0F), seed + 2U);
}

void put_balustrade(Site& site, const Mesh& turned, const glm::mat4& bay, std::uint32_t seed) {
    constexpr float kFoot = 0.14F;
    constexpr float kRail = 0.14F;
    for (const float middle : {-kArchX + 0.02F, kArchX - 0.02F}) {
        constexpr float kWidth = 1.36F;
        site.put(Surface::kStone, bevelled_box({kWidth, kFoot, 0.26F}, 0.015F),
                 bay * at(middle, kParapetFoot + 0.5F * kFoot, 0.0F), seed, shade(seed, 0.1F));
        site.put(Surface::kStone, bevelled_box({kWidth, kRail, 0.28F}, 0.03F),
                 bay * at(middle, kRailTop - 0.5F * kRail, 0.0F), seed + 1U,
                 shade(seed + 1U, 0.12F));
        constexpr int kCount = 6;
        for (int i = 0; i < kCount; ++i) {
            const float x = middle + kWidth * ((static_cast<float>(i) + 0.5F) / kCount - 0.5F);
            const auto own = seed + 3U + static_cast<std::uint32_t>(i);
            const float stretch = (kRailTop - kRail - kParapetFoot - kFoot) / 0.66F;
            const glm::mat4 place =
                glm::scale(bay * at(x, kParapetFoot + kFoot, 0.0F), vec3(1.0F, stretch, 1.0F));
            site.put(Surface::kStone, turned, place, own, shade(own, 0.16F));
        }
    }
}

void build_upper_bay(Site& site, const glm::mat4& bay, float along_m, std::uint32_t wall_seed,
                     std::uint32_t seed) {
    const float half = 0.5F * kBay;
    const glm::mat4 back = glm::rotate(glm::mat4(1.0F), glm::pi<float>(), vec3(0.0F, 1.0F, 0.0F));
    for (const int which : {-1, 1}) {
        const auto sign = static_cast<float>(which);
        const float x0 = which < 0 ? -half : 0.0F;
        const float x1 = which < 0 ? 0.0F : half;
        const Mesh front =
            arch_wall(x0, x1, sign * kArchX, kUpperSpringing, kRadius + 0.06F, kUpperTop, 2);
        const Mesh rear =
            arch_wall(-x1, -x0, -sign * kArchX, kUpperSpringing, kRadius + 0.06F, kUpperTop, 2);
        site.put(Surface::kAshlar, continued(front, along_m), bay * at(0.0F, 0.0F, kUpperHalf),
                 wall_seed);
        site.put(Surface::kAshlar, continued(rear, -along_m),
                 bay * back * at(0.0F, 0.0F, kUpperHalf), wall_seed + 50U);
        Ring ring;
        ring.centre_x = sign * kArchX;
        ring.springing = kUpperSpringing;
        ring.radius = kRadius;
        ring.width = 0.22F;
        ring.z0 = -kUpperHalf - 0.025F;
        ring.z1 = kUpperHalf + 0.025F;
        ring.blocks = 11;
        ring.seed = seed + 7U + (which < 0 ? 0U : 1U);
        put_voussoirs(site, ring, bay);
    }
}

void put_dentils(Site& site, const glm::mat4& frame, std::uint32_t seed) {
    const Mesh dentil = bevelled_box({0.09F, 0.09F, 0.14F}, 0.0F);
    constexpr int kCount = 120;
    for (int i = 0; i < kCount; ++i) {
        const float x = -kHalfLength + 2.0F * kHalfLength * (static_cast<float>(i) + 0.5F) / kCount;
        site.put(Surface::kStone, dentil, frame * at(x, kUpperTop + 0.205F, kUpperHalf + 0.11F),
                 seed + static_cast<std::uint32_t>(i));
    }
}

}  // namespace

void build_galleries(Site& site) {
    const Mesh turned = baluster();
    ColumnShape slender;
    slender.height = kUpperSpringing - kRailTop - 0.08F;
    slender.radius = 0.135F;
    slender.abacus = 0.42F;
    slender.segments = 18;
    slender.scrolls = false;
    slender.leaves = 6;
    slender.leaf_detail = 5;
    const Mesh pillar = column(slender);
    for (const int side : {-1, 1}) {
        const glm::mat4 frame = side_frame(side, kArcadeX - kWallHalf + kUpperHalf);
        const std::uint32_t seed = side < 0 ? 3000U : 4000U;
        for (int i = 0; i < kBays; ++i) {
            const float x = -kHalfLength + kBay * (static_cast<float>(i) + 0.5F);
            const glm::mat4 bay = frame * at(x, 0.0F, 0.0F);
            const auto own = seed + 20U * static_cast<std::uint32_t>(i);
            build_upper_bay(site, bay, x, seed + 700U, own);
            put_balustrade(site, turned, bay, own + 300U);
            // The bay's middle: a block in the balustrade, a slender column, an impost.
            site.put(Surface::kStone, bevelled_box({0.38F, kRailTop - kParapetFoot, 0.38F}, 0.02F),
                     bay * at(0.0F, 0.5F * (kRailTop + kParapetFoot), 0.0F), own + 1U);
            site.put(Surface::kStone, pillar, bay * at(0.0F, kRailTop, 0.0F), own + 2U,
                     shade(own, 0.1F));
            site.put(Surface::kStone, bevelled_box({0.46F, 0.08F, 0.52F}, 0.015F),
                     bay * at(0.0F, kUpperSpringing - 0.04F, 0.0F), own + 3U);
        }
        for (int i = 0; i <= kBays; ++i) {
            const float x = -kHalfLength + kBay * static_cast<float>(i);
            put_pier(site, frame * at(x, 0.0F, 0.0F),
                     seed + 800U + 4U * static_cast<std::uint32_t>(i));
        }
        site.put(Surface::kStone, moulding(main_cornice(), -kHalfLength, kHalfLength),
                 frame * at(0.0F, kUpperTop, kUpperHalf), seed + 900U);
        put_dentils(site, frame, seed + 1000U);
    }
}

}  // namespace obscura::stimuli::atrium
