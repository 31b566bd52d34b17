// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "renderer/base/random.h"
#include "stimuli/scenes/atrium/parts.h"

namespace obscura::stimuli::atrium {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

float draw(base::Random& random, float low, float high) {
    return static_cast<float>(random.uniform(low, high));
}

/// What the leaf texture holds, side by side: the sprays of a palm, oval leaves, lobed leaves.
enum class LeafKind { kPalm, kOval, kLobed };

/// A card that rises and bends over outwards (+z) and is folded along its middle; its texture cuts
/// out the leaf.
Mesh blade(LeafKind kind, float length, float width, float bend, float cup, int rows) {
    PatchOptions options;
    options.columns = 2;
    options.rows = rows;
    Mesh mesh = patch(options, [&](float u, float v) {
        const float across = (0.5F - u) * 2.0F;
        const float angle = bend * v;
        // A circular arc of that length.
        const float out = bend > 1e-3F ? length * (1.0F - std::cos(angle)) / bend : 0.0F;
        const float up = bend > 1e-3F ? length * std::sin(angle) / bend : length * v;
        const float lift = cup * width * across * across;
        return vec3(0.5F * width * across, up + lift * std::sin(angle),
                    out - lift * std::cos(angle));
    });
    for (renderer::Vertex& vertex : mesh.vertices) {
        vertex.uv.x = (static_cast<float>(kind) + 0.02F + 0.96F * vertex.uv.x) / 3.0F;
    }
    return mesh;
}

/// Long arching leaves from one crown.
Mesh palm(std::uint64_t seed, int leaves, float length) {
    base::Random random(seed);
    Mesh plant;
    for (int i = 0; i < leaves; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(leaves);
        const float turn = 2.399963F * static_cast<float>(i) + draw(random, -0.25F, 0.25F);
        const float tilt = glm::mix(0.1F, 0.75F, t) + draw(random, -0.1F, 0.1F);
        const Mesh leaf =
            blade(LeafKind::kPalm, length * draw(random, 0.75F, 1.1F),
                  0.24F * draw(random, 0.8F, 1.2F), draw(random, 0.7F, 1.7F), 0.25F, 10);
        Placement placement;
        placement.transform = glm::rotate(glm::mat4(1.0F), turn, vec3(0.0F, 1.0F, 0.0F)) *
                              glm::rotate(at(0.0F, 0.0F, 0.02F), tilt, vec3(1.0F, 0.0F, 0.0F));
        placement.tint =
            shade(static_cast<std::uint32_t>(seed) + static_cast<std::uint32_t>(i), 0.4F);
        append(plant, leaf, placement);
    }
    return plant;
}

/// A round bush: leaves on a ball of shoots, those inside darker.
Mesh bush(std::uint64_t seed, int leaves, float radius) {
    base::Random random(seed);
    Mesh plant;
    for (int i = 0; i < leaves; ++i) {
        const float height =
            1.0F - 1.55F * (static_cast<float>(i) + 0.5F) / static_cast<float>(leaves);
        const float turn = 2.399963F * static_cast<float>(i);
        const float flat = std::sqrt(std::max(0.0F, 1.0F - height * height));
        const vec3 out(flat * std::sin(turn), height, flat * std::cos(turn));
        const float far_out = draw(random, 0.45F, 1.0F);
        const vec3 centre =
            vec3(0.0F, radius * 0.85F, 0.0F) + out * radius * far_out * vec3(1.0F, 1.1F, 1.0F);
        const Mesh leaf = blade(LeafKind::kOval, draw(random, 0.13F, 0.21F),
                                draw(random, 0.075F, 0.115F), draw(random, 0.3F, 1.3F), 0.2F, 4);
        Placement placement;
        placement.transform =
            glm::rotate(glm::translate(glm::mat4(1.0F), centre), turn + draw(random, -0.7F, 0.7F),
                        vec3(0.0F, 1.0F, 0.0F)) *
            glm::rotate(glm::mat4(1.0F), draw(random, 0.5F, 1.7F), vec3(1.0F, 0.0F, 0.0F));
        placement.tint =
            shade(static_cast<std::uint32_t>(seed * 1000U) + static_cast<std::uint32_t>(i), 0.35F) *
            glm::mix(0.6F, 1.0F, far_out);
        append(plant, leaf, placement);
    }
    return plant;
}

/// What a bush's leaves grow on: shoots from the soil into the ball.
Mesh shoots_of_bush(std::uint64_t seed, float radius) {
    base::Random random(seed);
    constexpr int kShoots = 9;
    Mesh shoots;
    for (int i = 0; i < kShoots; ++i) {
        const float turn = 2.399963F * static_cast<float>(i) + draw(random, -0.4F, 0.4F);
        const vec3 out(std::sin(turn), 0.0F, std::cos(turn));
        const float spread = radius * draw(random, 0.2F, 0.6F);
        const std::vector<vec3> path{out * (0.03F + 0.25F * spread) - vec3(0.0F, 0.06F, 0.0F),
                                     out * 0.55F * spread + vec3(0.0F, 0.4F * radius, 0.0F),
                                     out * spread + vec3(0.0F, 0.95F * radius, 0.0F)};
        append(shoots, sweep(circle(0.009F, 6), frames_along(path, vec3(-out.z, 0.0F, out.x))));
    }
    return shoots;
}

/// Shoots that trail down a wall from the origin (the wall is at z < 0), thinning out downwards.
Mesh trailing(std::uint64_t seed, float width, float drop) {
    base::Random random(seed);
    Mesh plant;
    const int shoots = static_cast<int>(width * 8.0F);
    for (int s = 0; s < shoots; ++s) {
        const float start =
            width * ((static_cast<float>(s) + 0.5F) / static_cast<float>(shoots) - 0.5F);
        const float length = drop * draw(random, 0.35F, 1.0F);
        const float drift = draw(random, -0.25F, 0.25F);
        const int leaves = static_cast<int>(length * 13.0F);
        for (int i = 0; i < leaves; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(leaves);
            const vec3 place(start + drift * t * t + draw(random, -0.05F, 0.05F),
                             0.05F - length * t, draw(random, 0.0F, 0.07F));
            const Mesh leaf =
                blade(LeafKind::kLobed, draw(random, 0.09F, 0.14F) * (1.0F - 0.35F * t),
                      draw(random, 0.08F, 0.12F), draw(random, 0.3F, 1.0F), 0.2F, 3);
            Placement placement;
            placement.transform =
                glm::rotate(glm::translate(glm::mat4(1.0F), place), draw(random, -0.9F, 0.9F),
                            vec3(0.0F, 1.0F, 0.0F)) *
                glm::rotate(glm::mat4(1.0F), draw(random, 0.9F, 2.2F), vec3(1.0F, 0.0F, 0.0F));
            placement.tint = shade(static_cast<std::uint32_t>(random.below(100000)), 0.45F);
            append(plant, leaf, placement);
        }
    }
    return plant;
}

/// A wooden box of trailing plants that stands on the string course before the balustrade.
void put_flower_box(Site& site, int side, float x, float drop, std::uint32_t seed) {
    const glm::mat4 place =
        side_frame(side, kArcadeX - kWallHalf) * at(x, kLowerTop + 0.27F, 0.09F);
    site.put(
        Surface::kWood, bevelled_box({0.2F, 1.1F, 0.18F}, 0.012F),
        glm::rotate(place * at(0.0F, 0.1F, 0.02F), glm::half_pi<float>(), vec3(0.0F, 0.0F, 1.0F)),
        seed);
    site.put(Surface::kSoil, bevelled_box({1.04F, 0.03F, 0.12F}, 0.0F),
             place * at(0.0F, 0.195F, 0.02F), seed);
    site.put_mapped(Surface::kLeaf, trailing(seed, 1.0F, drop), place * at(0.0F, 0.22F, 0.115F));
    const Mesh tuft = bush(seed + 1U, 60, 0.15F);
    for (const float offset : {-0.35F, 0.0F, 0.35F}) {
        site.put_mapped(Surface::kLeaf, tuft, place * at(offset, 0.12F, 0.03F));
    }
}

/// A square stone trough with a rim, panels and feet.
void put_trough(Site& site, const glm::mat4& place, std::uint32_t seed) {
    constexpr float kSide = 0.82F;
    constexpr float kHeight = 0.62F;
    for (const float x : {-0.3F, 0.3F}) {
        for (const float z : {-0.3F, 0.3F}) {
            site.put(Surface::kStone, bevelled_box({0.16F, 0.09F, 0.16F}, 0.015F),
                     place * at(x, 0.045F, z), seed);
        }
    }
    for (int i = 0; i < 4; ++i) {
        const glm::mat4 turned = glm::rotate(place, static_cast<float>(i) * glm::half_pi<float>(),
                                             vec3(0.0F, 1.0F, 0.0F));
        const auto own = seed + static_cast<std::uint32_t>(i);
        const float shorter = (i & 1) != 0 ? 0.2F : 0.0F;
        site.put(Surface::kStone, bevelled_box({kSide - shorter, kHeight - 0.09F, 0.1F}, 0.02F),
                 turned * at(0.0F, 0.09F + 0.5F * (kHeight - 0.09F), 0.5F * kSide - 0.05F), own,
                 shade(own, 0.1F));
        site.put(Surface::kStone, bevelled_box({0.5F, 0.3F, 0.03F}, 0.012F),
                 turned * at(0.0F, 0.33F, 0.5F * kSide), own + 4U);
        site.put(Surface::kStone,
                 bevelled_box({kSide + 0.1F - 1.6F * shorter, 0.09F, 0.16F}, 0.025F),
                 turned * at(0.0F, kHeight, 0.5F * kSide - 0.03F), own + 8U);
    }
    site.put(Surface::kSoil,
             rectangle({-0.38F, 0.56F, -0.38F}, {0.0F, 0.0F, 0.76F}, {0.76F, 0.0F, 0.0F}), place,
             seed);
    site.put(Surface::kStone, bevelled_box({0.7F, 0.06F, 0.7F}, 0.0F),
             place * at(0.0F, 0.12F, 0.0F), seed);
}

Mesh pot() {
    const std::vector<vec2> profile{
        {0.0F, 0.0F},    {0.19F, 0.0F},  {0.2F, 0.02F},   {0.205F, 0.06F}, {0.235F, 0.2F},
        {0.27F, 0.35F},  {0.29F, 0.46F}, {0.33F, 0.47F},  {0.34F, 0.5F},   {0.34F, 0.55F},
        {0.325F, 0.57F}, {0.3F, 0.565F}, {0.285F, 0.54F}, {0.28F, 0.5F},   {0.0F, 0.49F}};
    return revolve(profile, 24);
}

Mesh amphora() {
    std::vector<vec2> profile{
        {0.0F, 0.0F}, {0.14F, 0.0F}, {0.15F, 0.02F}, {0.13F, 0.05F}, {0.1F, 0.08F}};
    for (int i = 0; i <= 11; ++i) {
        const float t = static_cast<float>(i) / 11.0F;
        const float belly = std::sin(glm::pi<float>() * std::pow(t, 0.8F));
        profile.emplace_back(0.09F + 0.19F * belly * (1.0F - 0.12F * t), 0.09F + 0.55F * t);
    }
    for (const vec2& point :
         {vec2(0.085F, 0.70F), vec2(0.085F, 0.76F), vec2(0.11F, 0.80F), vec2(0.12F, 0.825F),
          vec2(0.1F, 0.83F), vec2(0.075F, 0.8F), vec2(0.06F, 0.7F), vec2(0.0F, 0.68F)}) {
        profile.push_back(point);
    }
    Mesh vase = revolve(profile, 16);
    for (const float side : {-1.0F, 1.0F}) {
        std::vector<vec3> path;
        for (int i = 0; i <= 8; ++i) {
            const float t = static_cast<float>(i) / 8.0F;
            path.emplace_back(
                side * (0.073F + 0.16F * std::sin(0.92F * glm::pi<float>() * t) + 0.08F * t * t),
                0.77F - 0.26F * t, 0.0F);
        }
        append(vase, sweep(circle(0.018F, 6), frames_along(path, {0.0F, 0.0F, 1.0F})));
    }
    return vase;
}

Mesh chain(float length) {
    std::vector<vec3> loop;
    for (const vec2& point : circle(1.0F, 7))
        loop.emplace_back(0.017F * point.x, 0.03F * point.y, 0.0F);
    SweepOptions closed;
    closed.closed_path = true;
    const Mesh link =
        sweep(circle(0.0055F, 3), frames_along(loop, {0.0F, 0.0F, 1.0F}, true), closed);
    Mesh whole;
    constexpr float kStep = 0.047F;
    const int links = static_cast<int>(length / kStep);
    for (int i = 0; i < links; ++i) {
        Placement placement;
        placement.transform =
            glm::rotate(at(0.0F, -kStep * (static_cast<float>(i) + 0.5F), 0.0F),
                        (i & 1) != 0 ? glm::half_pi<float>() : 0.0F, vec3(0.0F, 1.0F, 0.0F));
        append(whole, link, placement);
    }
    return whole;
}

/// A six-sided lantern that hangs from `place` on a chain.
void put_lantern(Site& site, const glm::mat4& place, float chain_m) {
    site.put(Surface::kIron, chain(chain_m), place, 1U);
    const glm::mat4 top = place * at(0.0F, -chain_m, 0.0F);
    const std::vector<vec2> roof{{0.0F, -0.17F},  {0.15F, -0.17F},  {0.16F, -0.15F}, {0.1F, -0.09F},
                                 {0.05F, -0.05F}, {0.035F, -0.01F}, {0.0F, 0.0F}};
    const std::vector<vec2> glass{{0.0F, -0.5F}, {0.085F, -0.5F}, {0.115F, -0.17F}, {0.0F, -0.17F}};
    const std::vector<vec2> foot{{0.0F, -0.6F},   {0.02F, -0.58F}, {0.03F, -0.56F},
                                 {0.09F, -0.53F}, {0.105F, -0.5F}, {0.0F, -0.5F}};
    site.put(Surface::kIron, revolve(roof, 6, 0.2F), top, 2U);
    site.put(Surface::kLampGlass, revolve(glass, 6, 0.2F), top, 3U);
    site.put(Surface::kIron, revolve(foot, 6, 0.2F), top, 4U);
    for (int i = 0; i < 6; ++i) {
        const float turn = static_cast<float>(i) * glm::two_pi<float>() / 6.0F;
        const vec3 out(std::sin(turn), 0.0F, std::cos(turn));
        const std::vector<vec3> path{out * 0.09F + vec3(0.0F, -0.51F, 0.0F),
                                     out * 0.12F + vec3(0.0F, -0.165F, 0.0F)};
        site.put(Surface::kIron, sweep(circle(0.009F, 6), frames_along(path, out)), top, 5U);
    }
}

void put_planter(Site& site, vec3 foot, bool stone, int plant, std::uint32_t seed) {
    const glm::mat4 place =
        glm::rotate(glm::translate(glm::mat4(1.0F), foot), stone ? 0.0F : static_cast<float>(seed),
                    vec3(0.0F, 1.0F, 0.0F));
    if (stone) {
        put_trough(site, place, seed);
    } else {
        site.put(Surface::kRoof, pot(), place, seed, shade(seed, 0.2F));
        site.put(Surface::kSoil,
                 revolve(std::vector<vec2>{{0.285F, 0.5F}, {0.2F, 0.515F}, {0.0F, 0.52F}}, 24),
                 place, seed);
    }
    const glm::mat4 crown = place * at(0.0F, stone ? 0.55F : 0.5F, 0.0F);
    if (plant == 0) {
        site.put_mapped(Surface::kLeaf, palm(seed, 46, stone ? 1.35F : 1.05F), crown);
    } else {
        const float radius = stone ? 0.46F : 0.36F;
        site.put_mapped(Surface::kLeaf, bush(seed, stone ? 310 : 230, radius), crown);
        site.put(Surface::kWood, shoots_of_bush(seed, radius), crown, seed, vec3(0.55F));
    }
}

}  // namespace

void build_furnishings(Site& site) {
    const float line = kArcadeX - kWallHalf - 0.75F;
    // Beside columns along the court, and in the gallery.
    put_planter(site, {line, 0.0F, -3.6F}, true, 1, 301U);
    put_planter(site, {line, 0.0F, 3.6F}, true, 0, 302U);
    put_planter(site, {-line, 0.0F, 0.0F}, true, 1, 303U);
    put_planter(site, {-line, 0.0F, -7.2F}, true, 0, 304U);
    put_planter(site, {line + 0.1F, 0.0F, -9.9F}, false, 1, 305U);
    put_planter(site, {-line - 0.1F, 0.0F, -9.9F}, false, 0, 306U);
    put_planter(site, {line + 0.1F, 0.0F, 7.2F}, false, 1, 307U);
    put_planter(site, {4.8F, 0.0F, 1.1F}, false, 0, 308U);
    put_planter(site, {-6.1F, 0.0F, 1.9F}, false, 1, 309U);
    put_planter(site, {-6.1F, 0.0F, -5.3F}, false, 0, 310U);
    put_planter(site, {6.1F, kGalleryFloor, 3.6F}, false, 1, 311U);
    put_planter(site, {6.1F, kGalleryFloor, -3.6F}, false, 0, 312U);

    put_flower_box(site, 1, -1.8F - 0.92F, 1.5F, 321U);
    put_flower_box(site, 1, 2.64F, 1.2F, 322U);
    put_flower_box(site, -1, 4.48F, 1.4F, 323U);
    put_flower_box(site, -1, -2.7F, 1.3F, 324U);

    const Mesh vase = amphora();
    // On the sills of the aisle's niches: every third bay, one on the right side, is a door.
    for (const int side : {-1, 1}) {
        const glm::mat4 wall = side_frame(side, kAisleWallX);
        for (int i = 0; i < kBays; ++i) {
            if ((i + (side > 0 ? 1 : 0)) % 3 == 1) continue;
            const float x = -kHalfLength + kBay * (static_cast<float>(i) + 0.5F);
            const auto seed = 400U + static_cast<std::uint32_t>(10 * side + i + 20);
            const glm::mat4 place = glm::rotate(wall * at(x, 1.05F, -0.2F),
                                                static_cast<float>(seed), vec3(0.0F, 1.0F, 0.0F));
            site.put(i % 2 == 0 ? Surface::kRoof : Surface::kStone, vase,
                     glm::scale(place, vec3(0.62F + 0.08F * static_cast<float>(i % 3))), seed,
                     shade(seed, 0.3F));
        }
    }
    for (const vec3& foot : {vec3(-2.55F, 0.0F, 9.3F), vec3(4.35F, 0.0F, -2.2F),
                             vec3(4.85F, 0.0F, 4.9F), vec3(-4.75F, 0.0F, -3.9F)}) {
        const auto seed = static_cast<std::uint32_t>(500.0F + foot.z);
        site.put(Surface::kRoof, vase,
                 glm::scale(glm::translate(glm::mat4(1.0F), foot), vec3(1.25F)), seed,
                 shade(seed, 0.2F));
    }
    for (int i = 0; i < kBays; ++i) {
        const float z = -kHalfLength + kBay * (static_cast<float>(i) + 0.5F);
        if (i % 2 == 0) continue;
        put_lantern(site, at(-5.2F, kGalleryFloor - 0.3F, z + 0.35F), 1.3F);
        put_lantern(site, at(5.2F, kGalleryFloor - 0.3F, z + 0.35F), 1.3F);
    }
}

}  // namespace obscura::stimuli::atrium
