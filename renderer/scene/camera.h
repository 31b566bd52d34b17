// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// A camera's matrices for an image of a certain shape, in OpenGL's clip conventions.
struct CameraMatrices {
    glm::mat4 view_from_world{1.0F};
    glm::vec3 eye_m{0.0F};  ///< the camera in the world
    glm::mat4 clip_from_view{1.0F};
    glm::vec2 ray_scale{1.0F};   ///< view x, y per metre of depth at the right and upper border
    glm::vec2 ray_offset{0.0F};  ///< the same at the middle of the image
    float far_m = 100.0F;
};

/// The camera of an image that has every `step`-th column and row, from the first, of one of
/// width x height pixels: its pixels have the same rays. Its own size is that, divided and rounded
/// up.
[[nodiscard]] Camera every_so_many(const Camera& camera, int width, int height, int step);

/// Throws bad input naming the camera's field, its value and what is allowed.
[[nodiscard]] CameraMatrices matrices_of(const Camera& camera, int width, int height);

}  // namespace obscura::renderer
