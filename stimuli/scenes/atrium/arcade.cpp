// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/atrium/parts.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

constexpr float kRing = 0.4F;  // width of the voussoirs

/// The string course between the storeys, as (z, y) from the wall's face and kLowerTop.
std::vector<vec2> string_course() {
    return {{0.0F, 0.0F},    {0.045F, 0.0F},  {0.05F, 0.05F},  {0.06F, 0.07F},  {0.09F, 0.10F},
            {0.11F, 0.14F},  {0.115F, 0.15F}, {0.175F, 0.15F}, {0.18F, 0.155F}, {0.18F, 0.21F},
            {0.165F, 0.23F}, {0.13F, 0.25F},  {0.0F, 0.27F}};
}

/// One bay between two columns: wall, ring and impost blocks' tops, centred on x = 0.
void build_bay(Site& site, const glm::mat4& bay, float along_m, std::uint32_t wall_seed,
               std::uint32_t seed) {
    const float half = 0.5F * kBay;
    const Mesh wall = arch_wall(-half, half, 0.0F, kSpringing, kArchRadius + 0.1F, kLowerTop);
    const glm::mat4 back = glm::rotate(glm::mat4(1.0F), glm::pi<float>(), vec3(0.0F, 1.0F, 0.0F));
    site.put(Surface::kAshlar, continued(wall, along_m), bay * at(0.0F, 0.0F, kWallHalf),
             wall_seed);
    site.put(Surface::kAshlar, continued(wall, -along_m), bay * back * at(0.0F, 0.0F, kWallHalf),
             wall_seed + 100U);
    Ring ring;
    ring.springing = kSpringing;
    ring.radius = kArchRadius;
    ring.width = kRing;
    ring.seed = seed;
    put_voussoirs(site, ring, bay);
}

void build_supports(Site& site, const glm::mat4& frame, std::uint32_t seed) {
    ColumnShape shape;
    shape.height = kSpringing - 0.14F;
    const Mesh pillar = column(shape);
    const float impost_width = kBay - 2.0F * kArchRadius + 0.02F;
    const Mesh impost = bevelled_box({impost_width, 0.14F, 0.74F}, 0.02F);
    for (int i = 0; i <= kBays; ++i) {
        const float x = -kHalfLength + kBay * static_cast<float>(i);
        const auto own = seed + static_cast<std::uint32_t>(i);
        const bool at_end = i == 0 || i == kBays;
        if (at_end) {  // a pier against the end wall
            const float inwards = i == 0 ? 0.1F : -0.1F;
            const Mesh pier = bevelled_box({0.9F, kSpringing - 0.14F, 0.62F}, 0.02F);
            const Mesh foot = bevelled_box({1.0F, 0.3F, 0.74F}, 0.03F);
            site.put(Surface::kAshlar, pier,
                     frame * at(x + inwards, 0.5F * (kSpringing - 0.14F), 0.0F), own);
            site.put(Surface::kStone, foot, frame * at(x + inwards, 0.15F, 0.0F), own);
        } else {
            site.put(Surface::kStone, pillar, frame * at(x, 0.0F, 0.0F), own, shade(own, 0.22F));
        }
        site.put(Surface::kStone, impost, frame * at(x, kSpringing - 0.07F, 0.0F), own,
                 shade(own + 9U, 0.12F));
    }
}

}  // namespace

void build_arcades(Site& site) {
    for (const int side : {-1, 1}) {
        const glm::mat4 frame = side_frame(side, kArcadeX);
        const std::uint32_t seed = side < 0 ? 1000U : 2000U;
        for (int i = 0; i < kBays; ++i) {
            const float x = -kHalfLength + kBay * (static_cast<float>(i) + 0.5F);
            build_bay(site, frame * at(x, 0.0F, 0.0F), x, seed + 300U,
                      seed + 10U * static_cast<std::uint32_t>(i));
        }
        build_supports(site, frame, seed + 500U);
        site.put(Surface::kStone, moulding(string_course(), -kHalfLength, kHalfLength),
                 frame * at(0.0F, kLowerTop, kWallHalf), seed + 600U);
    }
}

}  // namespace obscura::stimuli::atrium
