// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/light/irradiance_grid.h"
#include "renderer/light/irradiance_parts.h"
#include "renderer/light/lighting.h"
#include "renderer/reference/ray_scene.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// What one ray of a probe meets.
struct ProbeHit {
    enum class Kind : std::uint8_t { kNothing, kFront, kBack };
    Kind kind = Kind::kNothing;
    glm::vec3 point_m{0.0F};  ///< in the world
    glm::vec3 normal{0.0F};   ///< of the triangle, towards the probe
    glm::vec3 albedo{0.0F};   ///< of the material with the mean of its texture
    glm::vec3 emitted{0.0F};  ///< radiance, the same
};

/// A scene's triangles with what light needs of their surfaces, from Embree without fused
/// multiplications.
class ProbeRays {
  public:
    explicit ProbeRays(const Scene& scene);

    /// What a ray from there meets first; the direction is a unit vector.
    [[nodiscard]] ProbeHit trace(const glm::vec3& from_m, const glm::vec3& direction) const;
    /// Irradiance / pi by the lights on a surface there, with shadows.
    [[nodiscard]] glm::vec3 direct_light(const Lighting& light, const glm::vec3& point_m,
                                         const glm::vec3& normal) const;

    /// Whether nothing stands between a point and one as far away as `far_m`.
    [[nodiscard]] bool sees(const glm::vec3& from_m, const glm::vec3& direction, float far_m) const;

  private:
    struct Surface {
        glm::vec3 albedo;
        glm::vec3 emitted;
    };
    const Scene& scene_;
    RayScene rays_;
    std::vector<Surface> surfaces_;  ///< by material
    float off_m_;                    ///< from a surface, so that a ray does not meet it again
};

}  // namespace obscura::renderer
