// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "renderer/frame/frame.h"
#include "renderer/light/lighting.h"
#include "renderer/reference/exr.h"

namespace obscura::stimuli {

/// The channels Z, N.X N.Y N.Z, albedo.R/G/B, ao.Y and light.R/G/B of a frame that was planned with
/// all buffers and one sample a pixel.
[[nodiscard]] renderer::FloatImage buffers_of(const renderer::Frame& frame,
                                              const renderer::Lighting& lighting);

/// The sixteen numbers as OpenGL stores them.
[[nodiscard]] std::array<float, 16> column_major(const glm::mat4& matrix);

}  // namespace obscura::stimuli
