// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <glm/glm.hpp>
#include <span>

#include "stimuli/scenes/support/assembly.h"
#include "stimuli/scenes/support/parts.h"

namespace obscura::stimuli::garden {

// The garden, metres. A brick wall runs along x at z = kWallZ, another along z at x = kSideX.
// Before the long wall lie a bed of plants, a gravel path and a lawn.
inline constexpr float kWallZ = -2.6F;
inline constexpr float kSideX = -3.9F;
inline constexpr float kRight = 6.2F;
inline constexpr float kFront = 6.0F;
inline constexpr float kWallHigh = 2.25F;
/// Where the wall along x has piers, and half of how wide they are.
inline constexpr std::array kPierX{2.45F, -1.15F};
inline constexpr float kPierHalf = 0.225F;
inline constexpr float kBedFront = -1.35F;  ///< where the bed ends and the path begins
inline constexpr float kPathFront = 0.75F;  ///< where the path ends and the lawn begins

enum class Surface {
    kBrick,  ///< one brick's face, coloured by the tint
    kMortar,
    kStone,
    kClay,  ///< flower pots
    kSoil,
    kGravel,
    kPebble,  ///< single stones, coloured by the tint
    kTurf,
    kZinc,
    kWood,
    // Cut out, mapped once; v runs from the root or stalk to the tip.
    kIvy,
    kFern,
    kTwig,
    kGrass,
    kFlower,
};
[[nodiscard]] std::span<const Finish> finishes();

// One file each; all add to the garden.
void build_walls(Assembly& garden);
void build_ground(Assembly& garden);
void build_climbers(Assembly& garden);   ///< ivy, the trees behind the wall
void build_border(Assembly& garden);     ///< ferns, shrubs, flowers, grasses
void build_ornaments(Assembly& garden);  ///< bench, urn, pots, can, spade

/// Tint of flowers' stems, on kPebble.
inline constexpr glm::vec3 kStem(0.14F, 0.26F, 0.09F);

/// The ground's height at a place.
[[nodiscard]] float ground_m(float x, float z);

/// A card from the origin along +Y that bends over towards +Z by `bend_rad` at its tip and is
/// folded along its middle; uv cover the texture once.
[[nodiscard]] renderer::Mesh card(float length_m, float width_m, float bend_rad, float fold,
                                  int rows, int columns = 2);

}  // namespace obscura::stimuli::garden
