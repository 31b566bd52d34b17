// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/gamepad.h"

#include <algorithm>
#include <cmath>

namespace obscura::app::explorer {
namespace {

constexpr float kDeadStick = 0.15F;
constexpr float kDeadTrigger = 0.05F;

/// From 0 at the end of the dead part to 1, so that nothing jumps; what is no number is nothing.
[[nodiscard]] float beyond(float value, float dead) {
    const float size = std::min(std::abs(value), 1.0F);
    return size > dead ? std::copysign((size - dead) / (1.0F - dead), value) : 0.0F;
}

}  // namespace

Push push_of_gamepad(std::span<const float, 6> axes) {
    const auto stick = [&](std::size_t axis) { return beyond(axes[axis], kDeadStick); };
    const auto trigger = [&](std::size_t axis) {
        return std::max(0.0F, beyond(0.5F * (axes[axis] + 1.0F), kDeadTrigger));
    };
    return {{stick(0), trigger(5) - trigger(4), -stick(1)}, {stick(2), -stick(3)}};
}

}  // namespace obscura::app::explorer
