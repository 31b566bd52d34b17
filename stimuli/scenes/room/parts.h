// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "stimuli/scenes/support/assembly.h"
#include "stimuli/scenes/support/parts.h"

namespace obscura::stimuli::room {

// The study, metres. The desk and the shelves stand against the wall at z = kBack; the window is
// in the wall at x = kLeft.
inline constexpr float kLeft = -2.4F;
inline constexpr float kRight = 2.5F;
inline constexpr float kBack = -2.0F;
inline constexpr float kFront = 2.4F;
inline constexpr float kHeight = 2.65F;
inline constexpr float kDeskTop = 0.74F;
// The window's opening.
inline constexpr float kSill = 0.86F;
inline constexpr float kLintel = 2.22F;
inline constexpr float kWindowBack = -1.32F;
inline constexpr float kWindowFront = 0.28F;

enum class Surface {
    kWall,
    kFloor,    ///< oak boards, along u
    kWood,     ///< furniture; grain along v
    kLacquer,  ///< white painted wood and metal
    kPaper,    ///< edges of pages, blank sheets
    kPrint,    ///< a printed page, mapped once
    kBinding,  ///< book cloth, near white; coloured by the tint
    kCurtain,
    kUpholstery,
    kRug,  ///< mapped once
    kMetal,
    kPlastic,  ///< near white; coloured by the tint
    kCeramic,
    kLeaf,  ///< one leaf, cut out, mapped once
    kSoil,
    kPicture,  ///< three pictures side by side
    kBulb,
};
[[nodiscard]] std::span<const Finish> finishes();

/// Where the bulb of the desk lamp is, and which way its shade points (unit length).
[[nodiscard]] glm::vec3 lamp_bulb_m();
[[nodiscard]] glm::vec3 lamp_axis();

// One file each; all add to the study.
void build_shell(Assembly& study);      ///< walls, floor, window, skirting
void build_fabrics(Assembly& study);    ///< curtains, rug, radiator's neighbour the armchair
void build_furniture(Assembly& study);  ///< desk, chair, shelves, radiator
void build_books(Assembly& study);      ///< on the shelves, the desk and the floor
void build_desk_things(Assembly& study);
void build_clutter(Assembly& study);  ///< plant, basket, pictures, cables, clock

/// A soft cushion around the origin: a rounded box that bulges.
[[nodiscard]] renderer::Mesh cushion(const glm::vec3& size_m, float bulge_m);

/// A closed book lying flat on the origin, its spine at -x, its front cover up.
struct Book {
    float width_m = 0.15F;   ///< spine to fore edge, along x
    float height_m = 0.22F;  ///< along z
    float thick_m = 0.03F;   ///< along y
    glm::vec3 cover{0.3F, 0.1F, 0.08F};
    glm::vec3 label{0.6F, 0.5F, 0.3F};
    std::uint32_t seed = 0;
};
void put_book(Assembly& study, const Book& book, const glm::mat4& place);
/// A book of random size and colour.
[[nodiscard]] Book draw_book(base::Random& random, float tallest_m);

// The shelves: their boards' upper faces, and the inner width.
inline constexpr std::array kShelf_m{0.09F, 0.47F, 0.83F, 1.16F, 1.49F, 1.82F};
inline constexpr float kShelfLeft = 0.42F;
inline constexpr float kShelfMiddle = 1.39F;
inline constexpr float kShelfRight = 2.36F;
inline constexpr float kShelfDepth = 0.28F;

}  // namespace obscura::stimuli::room
