// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// Axis-aligned box around a scene, metres.
struct Bounds {
    glm::vec3 low_m{0.0F};
    glm::vec3 high_m{0.0F};
};
/// The box of all vertices; a point at the origin for a scene without any.
[[nodiscard]] Bounds bounds_of(const Scene& scene);

/// Texels along a shadow map's side: a power of two from 1024 to 4096 that brings a texel to
/// about a centimetre where it can.
[[nodiscard]] int shadow_map_size(const Bounds& bounds);

/// The orthographic view of a light over the whole of a scene.
struct ShadowView {
    glm::mat4 shadow_from_world{1.0F};  ///< to [0, 1] in u, v and depth
    glm::mat4 clip_from_world{1.0F};    ///< to OpenGL's clip space
    float texel_m = 0.0F;               ///< width of one texel in the world
};
[[nodiscard]] ShadowView shadow_view(const Bounds& bounds, const DirectionalLight& light, int size);

/// Texels along each side of a point light's shadow cube.
inline constexpr int kPointShadowSize = 1024;

/// One side of the cube around a point light: +X -X +Y -Y +Z -Z for side 0 to 5. texel_m is the
/// width of a texel at a distance of 1 m. The furthest corner of the scene lies within; what is
/// nearer than a thousandth of that, or of a metre, is not seen.
[[nodiscard]] ShadowView point_shadow_view(const Bounds& bounds, const PointLight& light, int side);

}  // namespace obscura::renderer
