// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "renderer/light/shadow.h"
#include "renderer/scene/scene.h"

namespace obscura::app::explorer {

/// How a camera may be moved. All of these give a camera that a study file can say: named
/// stimuli::kStudyCamera, upright (looking straight up or down as a study has it), its field of
/// view the single-precision radians of single-precision degrees, no lens shift.
///
/// What is not finite moves nothing.

/// The same view as such a camera, as nearly as that can be.
[[nodiscard]] renderer::Camera upright(const renderer::Camera& camera);

/// By so many metres to the right, up and ahead, as the camera sees them.
[[nodiscard]] renderer::Camera flown(const renderer::Camera& camera, const glm::vec3& by_m);

/// Turned to the right and up where it stands; it never looks further up or down than 89 degrees.
[[nodiscard]] renderer::Camera turned(const renderer::Camera& camera, float right_rad,
                                      float up_rad);

/// Carried round a point, to the right and up, looking as before at what it looked at.
[[nodiscard]] renderer::Camera orbited(const renderer::Camera& camera, const glm::vec3& about_m,
                                       float right_rad, float up_rad);

/// With that vertical field of view, held to 1 to 170 degrees.
[[nodiscard]] renderer::Camera with_fov(const renderer::Camera& camera, float degrees);

/// Looking the same way from where all of the scene is seen, near and far planes to match.
[[nodiscard]] renderer::Camera framing(const renderer::Camera& camera,
                                       const renderer::Bounds& bounds, float aspect);

/// The point of the scene at that view depth under a place of the image, [0, 1] from its upper left
/// corner.
[[nodiscard]] glm::vec3 point_at(const renderer::Camera& camera, float aspect, const glm::vec2& at,
                                 float depth_m);

/// Whether the two show the same of any scene.
[[nodiscard]] bool same_view(const renderer::Camera& a, const renderer::Camera& b);

/// Metres a second that suit a scene: it is crossed in about ten seconds.
[[nodiscard]] float usual_speed_m_s(const renderer::Bounds& bounds);

}  // namespace obscura::app::explorer
