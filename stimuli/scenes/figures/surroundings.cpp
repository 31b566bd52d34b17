// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/noise.h"
#include "stimuli/scenes/support/parts.h"
#include "stimuli/scenes/support/texture_maker.h"

namespace obscura::stimuli::figures {
namespace {

/// Plain weave: threads over and under, the relief of a cloth.
TextureRecipe weave(const char* name, int threads, float size_m, float depth_m, float twill) {
    return {name, 512, 512, glm::vec2(size_m), [=](glm::vec2 uv) {
                const glm::vec2 q = uv * static_cast<float>(threads);
                const float pi = 3.1415926F;
                const float warp = std::abs(std::sin(pi * q.x));
                const float weft = std::abs(std::sin(pi * q.y));
                const float over = 0.5F + 0.5F *
                                              std::sin(pi * (q.x + (twill > 0.0F ? q.y : 0.0F))) *
                                              (twill > 0.0F ? 1.0F : std::sin(pi * q.y));
                const float thread = warp * over + weft * (1.0F - over);
                const float wear = fbm(uv * 6.0F, 5, 4, {6, 6});
                Texel texel;
                texel.albedo = glm::vec3(0.86F + 0.06F * thread + 0.10F * wear);
                texel.height_m = depth_m * thread;
                return texel;
            }};
}

TextureRecipe leather() {
    return {"leather",
            384,
            384,
            glm::vec2(0.12F),
            [](glm::vec2 uv) {
                const CellularNoise grain = cellular(uv * 46.0F, 3, {46, 46});
                const float crease = ridged(uv * 5.0F, 8, 3, {5, 5});
                Texel texel;
                texel.albedo = glm::vec3(
                    0.78F + 0.20F * std::min(1.0F, 1.6F * (grain.second - grain.nearest)) -
                    0.10F * std::max(0.0F, crease - 0.75F) * 4.0F);
                texel.height_m =
                    0.00022F * std::min(0.5F, grain.second - grain.nearest) - 0.00020F * crease;
                // Polished where it is rubbed, dull in its creases.
                texel.roughness = 0.60F - 0.12F * fbm(uv * 4.0F, 37, 3, {4, 4}) +
                                  0.8F * std::max(0.0F, crease - 0.70F);
                return texel;
            },
            true};
}

TextureRecipe skin() {
    return {"skin", 320, 320, glm::vec2(0.06F), [](glm::vec2 uv) {
                const CellularNoise pore = cellular(uv * 60.0F, 13, {60, 60});
                const float blotch = fbm(uv * 5.0F, 17, 4, {5, 5});
                Texel texel;
                texel.albedo =
                    glm::vec3(0.94F, 0.92F, 0.91F) + glm::vec3(0.05F, 0.035F, 0.03F) * blotch;
                texel.height_m =
                    0.00004F * std::min(0.6F, pore.second - pore.nearest) + 0.00006F * blotch;
                return texel;
            }};
}

TextureRecipe hair() {
    return {"hair", 256, 256, glm::vec2(0.05F), [](glm::vec2 uv) {
                const float strand = fbm(glm::vec2(uv.x * 48.0F, uv.y * 3.0F), 19, 3, {48, 3});
                Texel texel;
                const float lock = fbm(glm::vec2(uv.x * 10.0F, uv.y * 2.0F), 20, 2, {10, 2});
                texel.albedo = glm::vec3(0.70F + 0.42F * strand + 0.18F * lock);
                texel.height_m = 0.00035F * strand + 0.0003F * lock;
                return texel;
            }};
}

/// Four strips of hairs along v, side by side along u, each beginning and ending at its own place;
/// those of the last strip cover it whole but for its end.
TextureRecipe wisps() {
    constexpr int kHairs = 20;
    struct Hair {
        float at, bend, begins, ends, tone;
    };
    std::array<std::array<Hair, kHairs>, 4> strips{};
    for (int s = 0; s < 4; ++s) {
        for (int i = 0; i < kHairs; ++i) {
            const auto own = [&](int which) { return hash_unit(i, which, s, 47); };
            Hair& hair = strips[static_cast<std::size_t>(s)][static_cast<std::size_t>(i)];
            hair.at = (static_cast<float>(i) + 0.2F + 0.6F * own(0)) / kHairs;
            const float off = 2.0F * hair.at - 1.0F;
            // Hairs come in tufts whose ends are together.
            const float tuft = hash_unit(i / 4, 9, s, 47);
            hair.bend = 0.07F * (own(1) - 0.5F) - 0.05F * off;
            hair.begins = 0.11F * own(2) * own(2) + 0.05F * off * off;
            hair.ends = 1.0F - 0.26F * tuft - 0.12F * own(3) - 0.18F * off * off;
            hair.tone = 0.60F + 0.40F * own(4);
            if (s < 3) continue;
            hair.begins = -1.0F;
            hair.ends = 0.99F - 0.10F * tuft - 0.06F * own(3);
        }
    }
    return {"wisps", 512, 256, glm::vec2(0.06F, 0.04F), [strips](glm::vec2 uv) {
                const auto s = std::min(static_cast<std::size_t>(4.0F * uv.x), std::size_t{3});
                const float u = 4.0F * uv.x - static_cast<float>(s);
                Texel texel;
                texel.opacity = 0.0F;
                texel.albedo = glm::vec3(0.62F);
                float highest = 0.0F;
                for (const Hair& hair : strips[s]) {
                    if (uv.y < hair.begins || uv.y > hair.ends) continue;
                    const float t = uv.y / hair.ends;
                    const float thin = 0.040F * std::min(1.0F, 2.6F * (1.0F - t) + 0.25F) *
                                       std::min(1.0F, 0.35F + 9.0F * (uv.y - hair.begins));
                    const float off = std::abs(u - hair.at - hair.bend * t * t) / thin;
                    if (off > 1.0F) continue;
                    const float high = (1.0F - off * off) * (0.4F + hair.tone);
                    if (high <= highest) continue;
                    highest = high;
                    texel.opacity = 1.0F;
                    texel.albedo = glm::vec3(hair.tone * (0.72F + 0.28F * (1.0F - off * off)));
                    texel.height_m = 0.0003F * high;
                }
                if (s == 3 && uv.y < 0.80F) texel.opacity = 1.0F;
                return texel;
            }};
}

/// The same stone without joints: blocks have edges of their own.
TextureRecipe block() {
    return {"block",
            512,
            512,
            glm::vec2(1.6F),
            [](glm::vec2 uv) {
                const float rough = shared_noise(uv * 2.0F + 0.41F);
                const float pits = shared_noise(uv * 17.0F);
                const float dust = fbm(uv * 3.0F, 29, 4, {3, 3});
                Texel texel;
                texel.albedo = glm::vec3(0.36F, 0.33F, 0.28F) *
                               (0.95F + 0.20F * rough + 0.10F * pits + 0.10F * dust);
                texel.height_m = 0.0022F * rough + 0.0010F * pits;
                texel.roughness = 0.66F + 0.14F * rough + 0.10F * std::max(0.0F, dust);
                return texel;
            },
            true};
}

/// Worn slabs of stone, dusty in the joints.
TextureRecipe slabs() {
    return {"slabs",
            1024,
            1024,
            glm::vec2(1.6F),
            [](glm::vec2 uv) {
                const glm::vec2 q(uv.x * 2.0F, uv.y * 2.0F);
                const auto row = static_cast<int>(q.y);
                const float shifted = q.x + (row % 2 == 0 ? 0.0F : 0.5F);
                const int column = static_cast<int>(shifted) % 2;
                const float fx = shifted - std::floor(shifted);
                const float fy = q.y - std::floor(q.y);
                const float rough = shared_noise(uv * 2.0F + 0.41F);
                const float edge =
                    std::min(std::min(fx, 1.0F - fx), std::min(fy, 1.0F - fy)) + 0.006F * rough;
                const float joint = std::clamp((edge - 0.008F) / 0.012F, 0.0F, 1.0F);
                const float tone = 0.85F + 0.22F * hash_unit(column, row, 0, 4);
                const float dust = fbm(uv * 3.0F, 29, 4, {3, 3});
                Texel texel;
                texel.albedo =
                    glm::mix(glm::vec3(0.17F, 0.15F, 0.12F),
                             glm::vec3(0.36F, 0.33F, 0.28F) * tone * (1.0F + 0.22F * rough), joint);
                texel.albedo = glm::mix(texel.albedo, glm::vec3(0.40F, 0.36F, 0.30F),
                                        std::clamp(0.5F * dust + 0.15F, 0.0F, 0.6F));
                texel.height_m = 0.004F * joint + 0.0022F * rough;
                texel.roughness =
                    glm::mix(0.92F, 0.60F + 0.14F * rough + 0.20F * std::max(0.0F, dust), joint);
                return texel;
            },
            true};
}

}  // namespace

void add_materials(renderer::Scene& scene) {
    add_material(scene, {.name = "skin", .specular_intensity = 0.06F, .specular_power = 14.0F},
                 skin());
    add_material(scene, {.name = "hair", .specular_intensity = 0.06F, .specular_power = 16.0F},
                 hair());
    scene.materials.push_back({.name = "eye",
                               .albedo = glm::vec3(1.0F),
                               .specular_intensity = 0.6F,
                               .specular_power = 120.0F});
    add_material(scene, {.name = "jacket", .specular_intensity = 0.05F, .specular_power = 12.0F},
                 weave("canvas", 64, 0.10F, 0.00009F, 0.0F));
    add_material(scene, {.name = "shirt", .specular_intensity = 0.03F, .specular_power = 10.0F},
                 weave("linen", 64, 0.08F, 0.00008F, 0.0F));
    add_material(scene, {.name = "trousers", .specular_intensity = 0.03F, .specular_power = 10.0F},
                 weave("twill", 64, 0.08F, 0.00005F, 1.0F));
    add_material(scene, {.name = "leather", .specular_intensity = 0.07F}, leather());
    scene.materials.push_back({.name = "metal",
                               .albedo = glm::vec3(1.0F),
                               .specular_intensity = 0.7F,
                               .specular_power = 60.0F});
    add_material(scene, {.name = "ground", .specular_intensity = 0.04F}, slabs());
    add_material(scene,
                 {.name = "wisps",
                  .specular_intensity = 0.04F,
                  .specular_power = 16.0F,
                  .double_sided = true,
                  .coverage = renderer::Coverage::kCutOut},
                 wisps());
    add_material(scene, {.name = "block", .specular_intensity = 0.04F}, block());
}

void add_surroundings(renderer::Scene& scene) {
    renderer::Mesh ground;
    ground.name = "ground";
    ground.material = static_cast<std::uint32_t>(Cloth::kGround);
    PatchOptions floor;
    floor.columns = 40;
    floor.rows = 40;
    floor.size_m = {14.0F, 14.0F};
    Placement tiles;
    tiles.uv_scale = glm::vec2(1.0F / 1.6F);
    append(ground,
           patch(floor,
                 [](float u, float v) {
                     const float x = (u - 0.5F) * 14.0F;
                     const float z = (0.5F - v) * 14.0F;
                     const float far = std::max(0.0F, std::sqrt(x * x + z * z) - 1.2F);
                     return glm::vec3(
                         x, std::min(1.0F, far) * 0.02F * fbm(glm::vec2(x, z) * 0.8F, 31, 3), z);
                 }),
           tiles);
    // A low wall of blocks behind the two.
    renderer::Mesh wall;
    wall.name = "wall";
    wall.material = static_cast<std::uint32_t>(Cloth::kBlock);
    for (int row = 0; row < 2; ++row) {
        // What is between the blocks: where their corners are cut one would see through.
        Placement core;
        core.uv_scale = glm::vec2(1.0F / 1.6F);
        core.transform =
            moved(row % 2 == 0 ? 0.0F : 0.4F, 0.168F + 0.34F * static_cast<float>(row), -1.75F);
        core.tint = glm::vec3(0.60F);
        append(wall, bevelled_box({7.16F, 0.33F, 0.386F}, 0.004F), core);
    }
    for (int row = 0; row < 3; ++row) {
        for (int i = -4; i <= 4; ++i) {
            const float width = 0.80F;
            const float shift = row % 2 == 0 ? 0.0F : 0.4F;
            const float nudge = 0.003F * (hash_unit(i, row, 0, 9) - 0.5F);
            if (row == 2 && hash_unit(i, row, 1, 9) < 0.25F) continue;
            Placement place;
            place.uv_scale = glm::vec2(1.0F / 1.6F);
            place.uv_offset = {hash_unit(i, row, 2, 9), hash_unit(i, row, 3, 9)};
            place.transform[3] =
                glm::vec4(static_cast<float>(i) * width + shift + nudge,
                          0.17F + 0.34F * static_cast<float>(row), -1.75F + nudge, 1.0F);
            place.tint = glm::vec3(0.85F + 0.15F * hash_unit(i, row, 4, 9));
            append(wall, bevelled_box({width - 0.003F, 0.342F, 0.42F}, 0.018F), place);
        }
    }
    scene.meshes.push_back(std::move(ground));
    scene.meshes.push_back(std::move(wall));
}

}  // namespace obscura::stimuli::figures
