// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace obscura::stimuli {

/// Whether a camera's ray may leave the scene that way (unit length): sky, and nothing else.
using MayLeave = std::function<bool(const renderer::Camera& camera, const glm::vec3& way)>;

/// What is wrong with a scene's surfaces as its cameras see them, a line for each kind and mesh
/// with the number of rays and where the first was: the back of a closed surface (seen through a
/// hole: the rasteriser shows what is behind it), nothing at all where a ray may not leave, and two
/// faces turned the same way less than 1 mm apart, which fight for the same pixels. Cut-outs are
/// looked through. 480 x 270 rays a camera.
[[nodiscard]] std::vector<std::string> faults_as_seen(const renderer::Scene& scene,
                                                      const MayLeave& may_leave);

/// Connected opaque pieces that come no nearer than 3 mm to any other, a line for each mesh with
/// their number and where the first is. Cavities inside a solid are no pieces, and leaves and hairs
/// that are cut out of cards hang on stalks that are not modelled.
[[nodiscard]] std::vector<std::string> floating_pieces(const renderer::Scene& scene);

}  // namespace obscura::stimuli
