// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/gamepad.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace obscura::app::explorer {
namespace {

using Axes = std::array<float, 6>;

TEST(ExplorerGamepad, AtRestMovesNothingNorDoesAWornStick) {
    EXPECT_FALSE(push_of_gamepad(Axes{0, 0, 0, 0, -1, -1}).any());
    EXPECT_FALSE(push_of_gamepad(Axes{0.1F, -0.14F, 0.1F, 0.05F, -0.95F, -0.98F}).any());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(push_of_gamepad(Axes{nan, nan, nan, nan, nan, nan}).any());
}

TEST(ExplorerGamepad, PushesAheadRightAndUpAsItsSticksAndTriggersGo) {
    const Push ahead = push_of_gamepad(Axes{1, -1, 1, -1, -1, 1});
    EXPECT_EQ(ahead.fly, glm::vec3(1, 1, 1));
    EXPECT_EQ(ahead.turn, glm::vec2(1, 1));
    const Push back = push_of_gamepad(Axes{-1, 1, -1, 1, 1, -1});
    EXPECT_EQ(back.fly, glm::vec3(-1, -1, -1));
    EXPECT_EQ(back.turn, glm::vec2(-1, -1));
}

TEST(ExplorerGamepad, BeginsSoftlyWhereItsDeadPartEnds) {
    const float soft = push_of_gamepad(Axes{0.16F, 0, 0, 0, -1, -1}).fly.x;
    EXPECT_GT(soft, 0.0F);
    EXPECT_LT(soft, 0.02F);
    EXPECT_EQ(push_of_gamepad(Axes{3.0F, 0, 0, 0, -1, -1}).fly.x, 1.0F);
}

}  // namespace
}  // namespace obscura::app::explorer
