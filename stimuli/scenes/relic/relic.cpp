// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "stimuli/scenes/list.h"
#include "stimuli/scenes/relic/dragon.h"
#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/noise.h"
#include "stimuli/scenes/support/texture_maker.h"

namespace obscura::stimuli {
namespace {

/// Clouds and veins of the stone: a factor near 1.
glm::vec3 veined(const glm::vec3& p, const glm::vec3&, const glm::vec3& tint) {
    const float cloud = fbm(p * 5.0F, 21, 3);
    const float vein = ridged(p * 4.0F + 0.35F * cloud, 33, 2);
    const float light =
        1.0F + 0.07F * cloud - 0.06F * std::clamp((vein - 0.88F) * 8.0F, 0.0F, 1.0F);
    const glm::vec3 warm =
        glm::mix(glm::vec3(1.0F), glm::vec3(1.05F, 1.0F, 0.94F), 0.5F + 0.5F * cloud);
    return tint * light * warm;
}

/// The piece stands on y = 0: nobody sees what faces the ground there.
void leave_out_underside(renderer::Mesh& mesh) {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto on_ground = [&](std::size_t corner) {
            const renderer::Vertex& vertex = mesh.vertices[mesh.indices[i + corner]];
            return vertex.position_m.y < 0.001F && vertex.normal.y < -0.9F;
        };
        if (on_ground(0) && on_ground(1) && on_ground(2)) continue;
        kept.insert(kept.end(), mesh.indices.begin() + static_cast<std::ptrdiff_t>(i),
                    mesh.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
    }
    mesh.indices = std::move(kept);
}

/// What the piece stands on: a round of slate, whole in the views of the whole piece. Were it
/// larger, it would meet the border of the image, beyond which a technique finds nothing to sample:
/// a band.
renderer::Mesh stand() {
    constexpr float kRadius_m = 0.526F;
    const std::array<glm::vec2, 8> profile{{{0.0F, -0.036F},
                                            {kRadius_m - 0.006F, -0.036F},
                                            {kRadius_m, -0.030F},
                                            {kRadius_m, -0.010F},
                                            {kRadius_m - 0.004F, -0.003F},
                                            {kRadius_m - 0.011F, 0.0F},
                                            {0.30F, 0.0F},
                                            {0.0F, 0.0F}}};
    renderer::Mesh mesh;
    mesh.name = "stand";
    mesh.material = 1;
    Placement placement;
    placement.tint = glm::vec3(0.085F, 0.088F, 0.092F);
    append(mesh, revolve(profile, 160), placement);
    return mesh;
}

renderer::Scene build() {
    // A scale of the legs is 25 mm wide, a petal of the base 70 mm.
    constexpr float kBodyCell_m = 0.0055F;
    constexpr float kBaseCell_m = 0.0094F;
    constexpr float kHeadCell_m = 0.0038F;
    renderer::Scene scene;
    scene.name = "relic";
    scene.materials.push_back(
        {.name = "stone", .albedo = glm::vec3(1.0F), .specular_intensity = 0.0F});
    scene.materials.push_back(
        {.name = "slate", .albedo = glm::vec3(1.0F), .specular_intensity = 0.0F});
    const Curve spine = relic::spine();
    Sculpture body;
    relic::add_body(body, spine);
    relic::add_limbs(body);
    relic::add_crest(body, spine);
    Sculpture base;
    relic::add_base(base);
    Sculpture head;
    relic::add_head(head);
    relic::add_mane(head);
    const std::array pieces{std::tuple{"body", &body, kBodyCell_m},
                            std::tuple{"base", &base, kBaseCell_m},
                            std::tuple{"head", &head, kHeadCell_m}};
    scene.meshes.resize(pieces.size());
    for_each_row(static_cast<int>(pieces.size()), [&](int i) {
        const auto& [name, sculpture, cell_m] = pieces[static_cast<std::size_t>(i)];
        renderer::Mesh mesh = polygonise(*sculpture, cell_m, veined);
        mesh.name = name;
        leave_out_underside(mesh);
        scene.meshes[static_cast<std::size_t>(i)] = std::move(mesh);
    });
    scene.meshes.push_back(stand());
    // The first shows all of the piece, 1.15 m high, from where it covers the most of the image (a
    // search over directions and distances): a quarter. The others its other side, and its head.
    const auto camera = [](const char* name, glm::vec3 from, glm::vec3 at, float fov_rad) {
        renderer::Camera result;
        result.name = name;
        result.position_m = from;
        result.target_m = at;
        result.vertical_fov_rad = fov_rad;
        result.near_m = 0.1F;
        result.far_m = 10.0F;
        return result;
    };
    scene.cameras = {camera("front", {0.75F, 0.98F, 2.30F}, {0.0F, 0.507F, 0.0F}, 0.592F),
                     camera("side", {-2.9F, 0.95F, 1.2F}, {0.0F, 0.55F, 0.0F}, 0.50F),
                     camera("head", {-0.75F, 1.05F, 1.35F}, {-0.16F, 0.90F, 0.12F}, 0.42F)};
    return scene;
}

/// Light from everywhere, and a dark room behind.
renderer::Lighting lighting(Validity) {
    renderer::Lighting result;
    result.background = glm::vec3(0.135F, 0.138F, 0.142F);
    return result;
}

}  // namespace

BuiltinScene make_relic() {
    return {.id = "relic",
            .title = "A dragon carved in stone, coiled on a lotus base",
            .stands_in_for = "the Stanford dragon",
            .levels = {Validity::kLow},
            .cameras = {"front", "side", "head"},
            .build = build,
            .lighting = lighting};
}

}  // namespace obscura::stimuli
