// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>
#include <vector>

#include "renderer/scene/scene.h"
#include "stimuli/scenes/support/mesh_builder.h"

namespace obscura::stimuli::atrium {

// The building, metres. The court runs along z between two end walls; an arcade stands on either
// side of it at x = +-kArcadeX, and behind each an aisle below a gallery.
inline constexpr int kBays = 6;
inline constexpr float kBay = 3.6F;             ///< from column to column
inline constexpr float kHalfLength = 10.8F;     ///< the end walls' faces
inline constexpr float kArcadeX = 3.6F;         ///< middle of the arcade walls
inline constexpr float kWallHalf = 0.3F;        ///< half their thickness
inline constexpr float kAisleWallX = 6.6F;      ///< faces of the outer walls
inline constexpr float kSpringing = 3.5F;       ///< where the lower arches begin
inline constexpr float kArchRadius = 1.28F;     ///< clear
inline constexpr float kLowerTop = 5.3F;        ///< where the string course begins
inline constexpr float kGalleryFloor = 5.55F;   ///< walking surface
inline constexpr float kUpperSpringing = 8.0F;  ///< where the upper arches begin
inline constexpr float kUpperTop = 9.1F;        ///< where the main cornice begins
inline constexpr float kEaves = 9.56F;          ///< underside of the roof's edge

/// What a part is made of; each is one material and one mesh of the scene.
enum class Surface {
    kAshlar,   ///< walls of squared blocks
    kStone,    ///< smooth carved limestone
    kPlaster,  ///< aisle walls
    kFloor,    ///< tiles: each uses one of 4 x 4 cells of the texture
    kWood,     ///< beams, boards, doors; grain along v
    kRoof,     ///< fired clay: roof tiles, pots
    kCloth,    ///< near white; dyed by the tint
    kBanner,   ///< three banners side by side: red, green, blue
    kLeaf,
    kSoil,
    kIron,
    kLampGlass,
};
inline constexpr std::size_t kSurfaces = 12;

// Vegetable dyes, linear.
inline constexpr glm::vec3 kDyeRed(0.32F, 0.027F, 0.022F);
inline constexpr glm::vec3 kDyeGreen(0.050F, 0.155F, 0.060F);
inline constexpr glm::vec3 kDyeBlue(0.036F, 0.080F, 0.235F);
inline constexpr glm::vec3 kDyeGold(0.62F, 0.39F, 0.11F);

/// The scene while it grows.
class Site {
  public:
    Site();

    /// Adds a part. Its uv is moved by an amount that depends on `seed`, so that neighbours differ.
    void put(Surface surface, const renderer::Mesh& part, const glm::mat4& transform,
             std::uint32_t seed, const glm::vec3& tint = glm::vec3(1.0F));

    /// As put(), with uv taken as they are, in repeats of the texture.
    void put_mapped(Surface surface, const renderer::Mesh& part, const glm::mat4& transform,
                    const glm::vec3& tint = glm::vec3(1.0F));

    [[nodiscard]] renderer::Mesh& mesh(Surface surface) {
        return scene_.meshes[static_cast<std::size_t>(surface)];
    }

    /// The finished scene; the site is empty afterwards.
    [[nodiscard]] renderer::Scene take();

  private:
    renderer::Scene scene_;
    std::array<glm::vec2, kSurfaces> size_m_{};
};

/// One material a Surface, in that order, with baked textures. Gives the metres that one repeat of
/// each texture covers along u and v.
std::array<glm::vec2, kSurfaces> add_surfaces(renderer::Scene& scene);

// One file each; all add to the site.
void build_arcades(Site& site);      ///< lower columns, arches, string course
void build_galleries(Site& site);    ///< upper columns, arches, balustrades, main cornice
void build_shell(Site& site);        ///< floors, ceilings, roofs
void build_walls(Site& site);        ///< aisle walls and end walls with doors and niches
void build_relief(Site& site);       ///< the lion's mask on the end wall
void build_cloth(Site& site);        ///< curtains and banners
void build_furnishings(Site& site);  ///< planters, vases, lamps
/// Tone, dust, damp and rain streaks over whole walls, by place, in the vertex colours.
void weather(Site& site);

// Shared parts.

/// A wall whose texture is that of a longer wall, `along_m` from where its own x is 0: with one
/// seed, bays beside each other have no seam.
[[nodiscard]] renderer::Mesh continued(renderer::Mesh wall, float along_m);

/// Where `local` stands: x along a side, y up, z towards the court. `side` is -1 or +1 (of x).
[[nodiscard]] glm::mat4 side_frame(int side, float wall_x);

/// A wall's rectangle [x0, x1] x [springing, top] in the plane z = 0 facing +z, without the half
/// disc of `radius` around (centre_x, springing). uv in metres.
[[nodiscard]] renderer::Mesh arch_wall(float x0, float x1, float centre_x, float springing,
                                       float radius, float top, int rows = 4);

/// A flat rectangle from `origin` along two edges; the outside is cross(edge_u, edge_v).
/// Cells are at most `cell_m` long. v of its uv runs against edge_v, so that v goes down on walls.
[[nodiscard]] renderer::Mesh rectangle(glm::vec3 origin, glm::vec3 edge_u, glm::vec3 edge_v,
                                       float cell_m = 0.3F);

/// The inside of a half barrel over an opening: radius around (centre_x, springing), from z0 to z1.
[[nodiscard]] renderer::Mesh soffit(float centre_x, float springing, float radius, float z0,
                                    float z1);

/// An arch's ring.
struct Ring {
    float centre_x = 0.0F;
    float springing = 0.0F;
    float radius = 1.0F;  ///< inner
    float width = 0.4F;   ///< inner to outer
    float z0 = -0.33F;    ///< back
    float z1 = 0.33F;     ///< front
    int blocks = 13;      ///< odd: the middle one is the keystone
    std::uint32_t seed = 0;
};
/// Wedge-shaped blocks with rounded edges, each with its own shade.
void put_voussoirs(Site& site, const Ring& ring, const glm::mat4& transform);

/// A column from the origin up: plinth, base, shaft, capital with leaves, abacus.
struct ColumnShape {
    float height = 3.5F;
    float radius = 0.31F;  ///< of the shaft's foot
    float abacus = 1.0F;   ///< side length
    int segments = 24;
    int leaves = 8;        ///< in each of two rows
    int leaf_detail = 10;  ///< cells along and around each
    bool scrolls = true;   ///< volutes below the corners of the abacus
};
[[nodiscard]] renderer::Mesh column(const ColumnShape& shape);

/// A straight moulding from x0 to x1 whose profile (z outwards, y up) is open at the wall.
[[nodiscard]] renderer::Mesh moulding(const std::vector<glm::vec2>& profile, float x0, float x1);

[[nodiscard]] inline glm::mat4 at(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0F), glm::vec3(x, y, z));
}

/// A shade around 1 by a hash.
[[nodiscard]] glm::vec3 shade(std::uint32_t seed, float amount);

}  // namespace obscura::stimuli::atrium
