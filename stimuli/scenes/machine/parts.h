// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "stimuli/scenes/support/assembly.h"
#include "stimuli/scenes/support/parts.h"

namespace obscura::stimuli::machine {

// The engine, metres. Its cylinder lies along x; the crankshaft lies along z at x = kCrankX and
// carries the flywheel (z < 0) and the gear wheel (z > 0) that drives the generator's pinion.
inline constexpr float kFoundationTop = 0.16F;  ///< concrete
inline constexpr float kBedTop = 0.36F;         ///< the bed plate's working face
inline constexpr float kAxis = 0.80F;           ///< height of cylinder and shafts
inline constexpr float kCylinderX = -1.02F;     ///< middle of the cylinder
inline constexpr float kCylinderHalf = 0.31F;   ///< half its length
inline constexpr float kCrankX = 0.62F;
inline constexpr float kThrow = 0.20F;     ///< of the crank
inline constexpr float kCrankTurn = 0.9F;  ///< where the crank stands, rad from +x to +y
inline constexpr float kFlywheelZ = -0.66F;
inline constexpr float kGearZ = 0.52F;
inline constexpr float kTooth = 0.0165F;  ///< module: pitch diameter over number of teeth
inline constexpr int kWheelTeeth = 50;
inline constexpr int kPinionTeeth = 18;
inline constexpr float kWallZ = -1.95F;  ///< face of the hall's wall

enum class Surface {
    kEnamel,  ///< machine paint, near white; coloured by the tint
    kCast,    ///< raw cast iron
    kSteel,   ///< machined and oiled
    kBrass,
    kCopper,
    kRubber,
    kConcrete,
    kBrick,  ///< painted brick
    kTile,   ///< glazed wall tiles
    kZinc,   ///< galvanised sheet and gratings
    kWood,
    kDial,  ///< the face of a gauge, mapped once
    kDark,  ///< deep inside
};
[[nodiscard]] std::span<const Finish> finishes();

// Linear tints of the enamel.
inline constexpr glm::vec3 kGreen(0.085F, 0.165F, 0.115F);
inline constexpr glm::vec3 kBlueGrey(0.20F, 0.26F, 0.30F);
inline constexpr glm::vec3 kRed(0.42F, 0.045F, 0.030F);
inline constexpr glm::vec3 kYellow(0.62F, 0.40F, 0.06F);
inline constexpr glm::vec3 kCream(0.66F, 0.60F, 0.46F);

// One file each; all add to the hall.
void build_cylinder(Assembly& hall);   ///< bed, cylinder, valve chest, steam pipe
void build_engine(Assembly& hall);     ///< crosshead, rods, crank, bearings, flywheel, governor
void build_gears(Assembly& hall);      ///< gear wheel, pinion
void build_generator(Assembly& hall);  ///< finned generator with its cables
void build_cooler(Assembly& hall);     ///< plate fins, pump, oil pipes
void build_hall(Assembly& hall);       ///< floor, grating, wall, pipe runs, cabinet
void build_clutter(Assembly& hall);    ///< railings, tools, cans, hoist

// Fittings.

/// A bolt as bolt(), turned and worn by `seed`.
void put_bolt(Assembly& hall, const glm::mat4& place, float size_m, std::uint32_t seed);

/// A flange about +Y, `thick` high from the origin, with `bolts` bolts on its upper face.
void put_flange(Assembly& hall, Surface surface, const glm::mat4& place, float radius_m,
                float thick_m, int bolts, float bolt_m, const glm::vec3& tint = glm::vec3(1.0F));
/// A pair of flanges around the origin, along Y.
void put_joint(Assembly& hall, Surface surface, const glm::mat4& place, float pipe_m,
               const glm::vec3& tint = glm::vec3(1.0F));
/// A gate valve whose pipe lies along Y through the origin, its wheel out along +Z.
void put_valve(Assembly& hall, const glm::mat4& place, float pipe_m);
/// A round gauge facing +Z, its back at the origin.
void put_gauge(Assembly& hall, const glm::mat4& place, float radius_m);
/// A brass oil cup standing on the origin.
void put_oil_cup(Assembly& hall, const glm::mat4& place, float size_m);
/// A hand wheel about +Y at the origin.
void put_hand_wheel(Assembly& hall, const glm::mat4& place, float radius_m, const glm::vec3& tint);

}  // namespace obscura::stimuli::machine
