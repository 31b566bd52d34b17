// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace obscura::app::explorer {

/// What moves the camera: right, up and ahead by the speed; right and up by the pace of turning.
struct Push {
    glm::vec3 fly{0.0F};
    glm::vec2 turn{0.0F};
    [[nodiscard]] bool any() const { return fly != glm::vec3(0.0F) || turn != glm::vec2(0.0F); }
};

/// What a gamepad's axes push, in the order of GLFW's mapping: left stick x and y, right stick x
/// and y, left and right trigger; each -1 to 1, sticks down positive. The left stick flies, the
/// right one turns, the triggers go down and up; near its middle none does anything.
[[nodiscard]] Push push_of_gamepad(std::span<const float, 6> axes);

}  // namespace obscura::app::explorer
