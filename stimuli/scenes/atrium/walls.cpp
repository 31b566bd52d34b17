// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/atrium/parts.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;
using renderer::Vertex;

/// An arched recess in a wall, in the wall's frame (x along, y up, z out of the wall).
struct Opening {
    float centre_x = 0.0F;
    float foot = 0.0F;  ///< the sill, or the floor for a door
    float sill = 0.0F;  ///< height of the recess's floor, >= foot
    float springing = 2.0F;
    float radius = 0.7F;
    float depth = 0.3F;
    bool door = false;      ///< boards down to the floor
    bool shutters = false;  ///< boards down to the sill
};

/// The bay of wall [x0, x1] x [foot, top] around an opening.
struct Panel {
    float x0 = 0.0F;
    float x1 = 0.0F;
    float top = 5.0F;
    Surface surface = Surface::kPlaster;
};

/// A rectangle in the plane z whose uv are its place on the wall.
Mesh wall_rectangle(float x0, float x1, float y0, float y1, float z) {
    Mesh mesh = rectangle({x0, y0, z}, {x1 - x0, 0.0F, 0.0F}, {0.0F, y1 - y0, 0.0F}, 0.25F);
    for (Vertex& vertex : mesh.vertices) {
        vertex.uv = vec2(vertex.position_m.x, -vertex.position_m.y);
    }
    return mesh;
}

void put_leaves(Site& site, const Opening& o, const glm::mat4& frame, std::uint32_t seed) {
    const float foot = o.door ? o.foot : o.sill;
    const float height = o.springing + o.radius - foot;
    constexpr int kPlanks = 6;
    const float width = 2.0F * o.radius / kPlanks;
    const float z = -0.6F * o.depth;
    for (int i = 0; i < kPlanks; ++i) {
        const float x = o.centre_x - o.radius + width * (static_cast<float>(i) + 0.5F);
        const auto own = seed + static_cast<std::uint32_t>(i);
        site.put(Surface::kWood, bevelled_box({width - 0.006F, height, 0.06F}, 0.012F),
                 frame * at(x, foot + 0.01F + 0.5F * height, z), own, shade(own, 0.25F));
    }
    // No light between the boards.
    site.put(Surface::kWood, bevelled_box({2.0F * o.radius, height, 0.03F}, 0.0F),
             frame * at(o.centre_x, foot + 0.01F + 0.5F * height, z - 0.04F), seed + 9U,
             vec3(0.3F));
    for (const float y : {0.14F, 0.42F, 0.68F}) {
        const float at_y = foot + y * height;
        site.put(Surface::kIron, bevelled_box({2.0F * o.radius - 0.12F, 0.06F, 0.016F}, 0.005F),
                 frame * at(o.centre_x, at_y, z + 0.036F), seed);
        for (int i = 0; i < kPlanks; i += 2) {
            const float x = o.centre_x - o.radius + width * (static_cast<float>(i) + 1.0F);
            site.put(Surface::kIron, bevelled_box({0.03F, 0.03F, 0.03F}, 0.0F),
                     frame * at(x, at_y, z + 0.045F), seed);
        }
    }
    std::vector<vec3> loop;
    for (const vec2& point : circle(0.075F, 10)) loop.emplace_back(point.x, point.y, 0.0F);
    SweepOptions closed;
    closed.closed_path = true;
    const Mesh handle =
        sweep(circle(0.011F, 4), frames_along(loop, {0.0F, 0.0F, 1.0F}, true), closed);
    for (const float x : {-0.13F, 0.13F}) {
        site.put(Surface::kIron, handle,
                 frame * at(o.centre_x + x, foot + 0.5F * height, z + 0.038F), seed);
    }
    site.put(Surface::kWood, bevelled_box({0.09F, height, 0.04F}, 0.01F),
             frame * at(o.centre_x, foot + 0.5F * height, z + 0.034F), seed + 20U);
}

void put_frame(Site& site, const Opening& o, const glm::mat4& frame, std::uint32_t seed) {
    constexpr float kWidth = 0.2F;
    Ring ring;
    ring.centre_x = o.centre_x;
    ring.springing = o.springing;
    ring.radius = o.radius - 0.03F;
    ring.width = kWidth;
    ring.z0 = -0.1F;
    ring.z1 = 0.05F;
    ring.blocks = 7;
    ring.seed = seed;
    put_voussoirs(site, ring, frame);
    const int blocks = 3;
    const float step = (o.springing - o.sill) / static_cast<float>(blocks);
    for (const float side : {-1.0F, 1.0F}) {
        for (int i = 0; i < blocks; ++i) {
            // Long and short blocks take turns.
            const float wide = kWidth + ((i & 1) != 0 ? 0.07F : 0.0F);
            const auto own = seed * 16U + static_cast<std::uint32_t>(i) + (side > 0.0F ? 4U : 0U);
            site.put(Surface::kStone, bevelled_box({wide, step * 0.997F, 0.15F}, 0.012F),
                     frame * at(o.centre_x + side * (ring.radius + 0.5F * wide),
                                o.sill + step * (static_cast<float>(i) + 0.5F), -0.025F),
                     own, shade(own, 0.2F));
        }
    }
    if (!o.door) {
        site.put(Surface::kStone, bevelled_box({2.0F * o.radius + 0.5F, 0.12F, 0.26F}, 0.02F),
                 frame * at(o.centre_x, o.sill - 0.056F, 0.0F), seed + 3U);
    }
}

/// The wall around an opening, the recess and its frame.
void put_panel(Site& site, const Panel& panel, const Opening& o, const glm::mat4& frame,
               std::uint32_t wall_seed, std::uint32_t seed) {
    const glm::mat4 none(1.0F);
    const auto wall = [&](const Mesh& part) { site.put(panel.surface, part, frame, wall_seed); };
    const float left = o.centre_x - o.radius;
    const float right = o.centre_x + o.radius;
    wall(arch_wall(panel.x0, panel.x1, o.centre_x, o.springing, o.radius, panel.top));
    wall(wall_rectangle(panel.x0, left, o.foot, o.springing, 0.0F));
    wall(wall_rectangle(right, panel.x1, o.foot, o.springing, 0.0F));
    if (o.sill > o.foot) wall(wall_rectangle(left, right, o.foot, o.sill, 0.0F));
    wall(wall_rectangle(left - 0.05F, right + 0.05F, o.sill - 0.05F, o.springing + o.radius + 0.05F,
                        -o.depth));
    wall(soffit(o.centre_x, o.springing, o.radius, -o.depth, 0.0F));
    const float jamb = o.springing - o.sill;
    wall(rectangle({left, o.sill, 0.0F}, {0.0F, 0.0F, -o.depth}, {0.0F, jamb, 0.0F}));
    wall(rectangle({right, o.sill, -o.depth}, {0.0F, 0.0F, o.depth}, {0.0F, jamb, 0.0F}));
    wall(rectangle({left, o.sill + (o.door ? 0.01F : 0.0F), 0.0F}, {2.0F * o.radius, 0.0F, 0.0F},
                   {0.0F, 0.0F, -o.depth}));
    put_frame(site, o, frame, seed);
    if (o.door || o.shutters) put_leaves(site, o, frame, seed + 30U);
}

/// A plinth of stone blocks along the foot of a wall, left out at a door.
void put_plinth(Site& site, const glm::mat4& frame, float x0, float x1, std::uint32_t seed) {
    const int blocks = std::max(1, static_cast<int>((x1 - x0) / 1.0F + 0.5F));
    const float step = (x1 - x0) / static_cast<float>(blocks);
    for (int i = 0; i < blocks; ++i) {
        const float x = x0 + step * (static_cast<float>(i) + 0.5F);
        const auto own = seed + static_cast<std::uint32_t>(i);
        site.put(Surface::kStone, bevelled_box({step * 0.997F, 0.5F, 0.12F}, 0.015F),
                 frame * at(x, 0.25F, 0.0F), own, shade(own, 0.18F));
        site.put(Surface::kStone, bevelled_box({step * 0.997F, 0.09F, 0.18F}, 0.03F),
                 frame * at(x, 0.545F, 0.0F), own, shade(own + 7U, 0.12F));
    }
}

void build_aisle_wall(Site& site, int side) {
    const glm::mat4 frame = side_frame(side, kAisleWallX);
    const std::uint32_t seed = side < 0 ? 60000U : 62000U;
    for (int i = 0; i < kBays; ++i) {
        const float x = -kHalfLength + kBay * (static_cast<float>(i) + 0.5F);
        const auto own = seed + 40U * static_cast<std::uint32_t>(i);
        Panel panel{x - 0.5F * kBay, x + 0.5F * kBay, kGalleryFloor - 0.2F, Surface::kPlaster};
        Opening lower;
        lower.centre_x = x;
        lower.door = (i + (side > 0 ? 1 : 0)) % 3 == 1;
        lower.sill = lower.door ? 0.0F : 1.05F;
        lower.springing = lower.door ? 2.2F : 2.35F;
        lower.radius = lower.door ? 0.72F : 0.52F;
        lower.depth = lower.door ? 0.34F : 0.42F;
        put_panel(site, panel, lower, frame, seed, own);
        const float gap = lower.door ? lower.radius + 0.26F : 0.0F;
        put_plinth(site, frame, panel.x0, x - gap, own + 900U);
        put_plinth(site, frame, x + gap, panel.x1, own + 910U);
        Opening upper;
        upper.centre_x = x;
        upper.foot = kGalleryFloor - 0.05F;
        upper.door = !lower.door;
        upper.sill = upper.door ? kGalleryFloor : kGalleryFloor + 0.95F;
        upper.springing = kGalleryFloor + (upper.door ? 1.9F : 2.1F);
        upper.radius = upper.door ? 0.55F : 0.5F;
        panel.top = kUpperTop;
        put_panel(site, panel, upper, frame, seed + 1U, own + 500U);
    }
    // Closed behind the recesses.
    site.put(Surface::kPlaster, bevelled_box({2.0F * kHalfLength + 1.6F, 11.6F, 0.3F}, 0.0F),
             frame * at(0.0F, 5.6F, -0.75F), seed + 3U);
}

void build_end_wall(Site& site, float facing, std::uint32_t seed) {
    glm::mat4 frame = at(0.0F, 0.0F, -kHalfLength * facing);
    if (facing < 0.0F) frame = glm::rotate(frame, glm::pi<float>(), vec3(0.0F, 1.0F, 0.0F));
    const float half = kAisleWallX + 0.05F;
    const auto put_door = [&](float x0, float x1, float radius, float springing,
                              std::uint32_t own) {
        Opening door;
        door.centre_x = 0.5F * (x0 + x1);
        door.springing = springing;
        door.radius = radius;
        door.depth = 0.45F;
        door.door = true;
        put_panel(site, {x0, x1, kLowerTop, Surface::kAshlar}, door, frame, seed, own);
        const float gap = radius + 0.26F;
        put_plinth(site, frame, x0, door.centre_x - gap, own + 50U);
        put_plinth(site, frame, door.centre_x + gap, x1, own + 60U);
    };
    put_door(-kArcadeX, kArcadeX, 1.05F, 2.3F, seed + 100U);
    put_door(-half, -kArcadeX, 0.62F, 2.1F, seed + 200U);
    put_door(kArcadeX, half, 0.62F, 2.1F, seed + 300U);
    const auto wall = [&](float x0, float x1, float y0, float y1) {
        site.put(Surface::kAshlar, wall_rectangle(x0, x1, y0, y1, 0.0F), frame, seed);
    };
    // Above: a window with shutters on either side of the middle.
    wall(-half, -3.2F, kLowerTop, kEaves);
    wall(-1.4F, 1.4F, kLowerTop, kEaves);
    wall(3.2F, half, kLowerTop, kEaves);
    wall(-3.2F, -1.4F, kUpperSpringing + 0.9F, kEaves);
    wall(1.4F, 3.2F, kUpperSpringing + 0.9F, kEaves);
    for (const float side : {-1.0F, 1.0F}) {
        Opening window;
        window.centre_x = side * 2.3F;
        window.foot = kLowerTop;
        window.sill = 6.3F;
        window.springing = kUpperSpringing - 0.1F;
        window.radius = 0.46F;
        window.shutters = true;
        const Panel panel{window.centre_x - 0.9F, window.centre_x + 0.9F, kUpperSpringing + 0.9F,
                          Surface::kAshlar};
        put_panel(site, panel, window, frame, seed, seed + (side > 0.0F ? 400U : 500U));
    }
    // Gables beside the court, under the roofs, and the thickness of the wall.
    site.put(Surface::kAshlar, bevelled_box({15.0F, 11.2F, 0.3F}, 0.0F),
             frame * at(0.0F, 5.4F, -0.8F), seed + 1U);
    site.put(Surface::kStone, bevelled_box({2.0F * kArcadeX, 0.14F, 1.1F}, 0.03F),
             frame * at(0.0F, kEaves + 0.05F, -0.35F), seed + 2U);
    const std::vector<vec2> band{{0.0F, 0.0F},   {0.05F, 0.0F},  {0.06F, 0.06F}, {0.1F, 0.1F},
                                 {0.16F, 0.12F}, {0.16F, 0.19F}, {0.12F, 0.22F}, {0.0F, 0.24F}};
    for (const float y : {kLowerTop + 0.015F, kUpperTop + 0.2F}) {
        site.put(Surface::kStone, moulding(band, -kArcadeX, kArcadeX), frame * at(0.0F, y, 0.0F),
                 seed + 4U);
    }
}

}  // namespace

void build_walls(Site& site) {
    build_aisle_wall(site, -1);
    build_aisle_wall(site, 1);
    build_end_wall(site, 1.0F, 65000U);
    build_end_wall(site, -1.0F, 67000U);
}

}  // namespace obscura::stimuli::atrium
