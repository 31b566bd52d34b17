// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "renderer/scene/scene.h"

namespace obscura::stimuli {

/// What a surface is at one point.
struct Texel {
    glm::vec3 albedo{0.5F};  ///< linear Rec. 709, clamped to [0, 1] when stored
    float height_m = 0.0F;   ///< of the fine relief, along the normal
    float opacity = 1.0F;    ///< the albedo texture's alpha, clamped to [0, 1] when stored
    float roughness = 1.0F;  ///< stored where the recipe says so, clamped to [0, 1]
};

/// A surface to bake: `at` takes uv in [0, 1)^2 and must wrap at 1 (use periodic noise). It is
/// called from several threads at once.
struct TextureRecipe {
    std::string name;
    int width = 1024;
    int height = 1024;
    glm::vec2 size_m{1.0F};  ///< what one repeat of the texture covers, along u and v
    std::function<Texel(glm::vec2 uv)> at;
    bool roughness = false;  ///< whether the surface's roughness is baked too
};

/// The images of a surface; all wrap.
struct BakedTextures {
    renderer::Texture albedo;  ///< sRGB, name "NAME-albedo"
    renderer::Texture normal;  ///< tangent space, +Y towards +v, name "NAME-normal"
    std::optional<renderer::Texture> roughness;  ///< green, name "NAME-roughness"
};

/// Bakes on all cores; the bytes do not depend on how many there are.
[[nodiscard]] BakedTextures bake(const TextureRecipe& recipe);

/// Bakes, adds the textures to the scene and a material that uses them, and returns its index.
/// `material` gives everything but their indices; where roughness is baked, its specular_power is
/// not used.
std::uint32_t add_material(renderer::Scene& scene, renderer::Material material,
                           const TextureRecipe& recipe);

/// sRGB code value of a linear value, which is clamped to [0, 1] (IEC 61966-2-1).
[[nodiscard]] std::uint8_t encode_srgb(float linear);

/// Linear value of an sRGB colour written as 0xRRGGBB, for colours picked by eye.
[[nodiscard]] glm::vec3 linear_from_srgb(std::uint32_t rgb);

/// The same of a constant, converted once: for recipes, which ask at every texel.
template <std::uint32_t kSrgb>
[[nodiscard]] const glm::vec3& colour() {
    static const glm::vec3 linear = linear_from_srgb(kSrgb);
    return linear;
}

/// Calls `row(y)` for y in [0, rows), on all cores. What the calls write must not overlap.
void for_each_row(int rows, const std::function<void(int)>& row);

}  // namespace obscura::stimuli
