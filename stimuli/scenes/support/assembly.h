// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "renderer/scene/scene.h"
#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/texture_maker.h"

namespace obscura::stimuli {

inline constexpr float kBaked = 0.0F;

/// What a surface of a scene looks like.
struct Finish {
    const char* name = "";
    Texel (*at)(glm::vec2 uv) = nullptr;  ///< as TextureRecipe::at
    int width = 512;                      ///< texels along u
    int height = 512;                     ///< texels along v
    float repeat_m = 1.0F;  ///< what one repeat covers along u; along v by the texture's shape
    float specular_intensity = 0.0F;  ///< [0, 1]
    float specular_power = 16.0F;     ///< [1, 255], or kBaked: by the texels' roughness
    bool double_sided = false;
    bool cut_out = false;      ///< the texels' opacity cuts holes
    glm::vec3 emissive{0.0F};  ///< linear radiance sent out
};

/// Bakes a finish and adds its material as the scene's last; gives what one repeat of its textures
/// covers along u and v, in metres.
glm::vec2 add_finish(renderer::Scene& scene, const Finish& finish);

/// A scene while it grows: one material and one mesh for each of its finishes, in their order.
/// `Surface` is the scene's own enumeration of them.
class Assembly {
  public:
    /// Bakes the finishes.
    Assembly(std::string name, std::span<const Finish> finishes);

    /// Adds a part whose uv are in metres. They are moved by an amount that depends on `seed`, so
    /// that neighbours differ. `tint` multiplies the colour, [0, 1].
    template <typename Surface>
    void put(Surface surface, const renderer::Mesh& part, const glm::mat4& transform,
             std::uint32_t seed, const glm::vec3& tint = glm::vec3(1.0F)) {
        put_at(static_cast<std::size_t>(surface), part, transform, seed, tint);
    }

    /// As put(), with uv in repeats of the texture, taken as they are.
    template <typename Surface>
    void put_mapped(Surface surface, const renderer::Mesh& part, const glm::mat4& transform,
                    const glm::vec3& tint = glm::vec3(1.0F)) {
        Placement placement;
        placement.transform = transform;
        placement.tint = tint;
        append(scene_.meshes[static_cast<std::size_t>(surface)], part, placement);
    }

    template <typename Surface>
    [[nodiscard]] renderer::Mesh& mesh(Surface surface) {
        return scene_.meshes[static_cast<std::size_t>(surface)];
    }

    /// The finished scene without the meshes that nothing was put in; empty afterwards.
    [[nodiscard]] renderer::Scene take();

  private:
    void put_at(std::size_t surface, const renderer::Mesh& part, const glm::mat4& transform,
                std::uint32_t seed, const glm::vec3& tint);

    renderer::Scene scene_;
    std::vector<glm::vec2> size_m_;
};

/// A camera by where it stands and looks. `near_m` 0.05, `far_m` as given.
[[nodiscard]] renderer::Camera camera_at(std::string name, glm::vec3 position_m, glm::vec3 target_m,
                                         float vertical_fov_deg, float far_m);

}  // namespace obscura::stimuli
