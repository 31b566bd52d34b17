// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/flight.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <limits>

#include "renderer/base/random.h"
#include "renderer/scene/camera.h"

namespace obscura::app::explorer {
namespace {

renderer::Camera ahead() {
    renderer::Camera camera;
    camera.position_m = {1.0F, 2.0F, 3.0F};
    camera.target_m = {1.0F, 2.0F, -1.0F};
    camera.vertical_fov_rad = glm::radians(50.0F);
    return camera;
}

void expect_near(const glm::vec3& value, const glm::vec3& wanted, float tolerance) {
    EXPECT_NEAR(value.x, wanted.x, tolerance);
    EXPECT_NEAR(value.y, wanted.y, tolerance);
    EXPECT_NEAR(value.z, wanted.z, tolerance);
}

glm::vec4 clip_of(const renderer::Camera& camera, const glm::vec3& point) {
    const auto matrices = renderer::matrices_of(camera, 160, 90);
    return matrices.clip_from_view * (matrices.view_from_world * glm::vec4(point, 1.0F));
}

TEST(ExplorerFlight, FlyingGoesByTheCamerasOwnAxes) {
    const renderer::Camera camera = flown(ahead(), {0.5F, 0.25F, 2.0F});
    expect_near(camera.position_m, {1.5F, 2.25F, 1.0F}, 1e-5F);
    expect_near(camera.target_m - camera.position_m, {0.0F, 0.0F, -4.0F}, 1e-5F);
}

TEST(ExplorerFlight, TurningToTheRightAndBackIsWhereItWas) {
    const renderer::Camera right = turned(ahead(), glm::half_pi<float>(), 0.0F);
    expect_near(glm::normalize(right.target_m - right.position_m), {1.0F, 0.0F, 0.0F}, 1e-5F);
    const renderer::Camera back = turned(right, -glm::half_pi<float>(), 0.0F);
    expect_near(back.target_m, ahead().target_m, 1e-4F);
}

TEST(ExplorerFlight, NoTurnLooksStraightUpOrDown) {
    renderer::Camera camera = ahead();
    for (int i = 0; i < 20; ++i) camera = turned(camera, 0.1F, 0.5F);
    const glm::vec3 direction = glm::normalize(camera.target_m - camera.position_m);
    EXPECT_LT(direction.y, 0.99999F);
    EXPECT_GT(direction.y, 0.999F);
}

TEST(ExplorerFlight, WhatIsOrbitedStaysAtItsPlaceInTheImage) {
    const glm::vec3 about{1.7F, 2.4F, -0.5F};
    const renderer::Camera before = upright(ahead());
    const renderer::Camera after = orbited(before, about, 0.6F, 0.3F);
    const glm::vec4 first = clip_of(before, about);
    const glm::vec4 second = clip_of(after, about);
    EXPECT_NEAR(first.x / first.w, second.x / second.w, 1e-4F);
    EXPECT_NEAR(first.y / first.w, second.y / second.w, 1e-4F);
    EXPECT_NEAR(glm::length(about - before.position_m), glm::length(about - after.position_m),
                1e-4F);
}

TEST(ExplorerFlight, ThePointUnderAPlaceOfTheImageProjectsBackToIt) {
    const renderer::Camera camera = turned(ahead(), 0.3F, -0.2F);
    const glm::vec3 point = point_at(camera, 16.0F / 9.0F, {0.8F, 0.3F}, 5.0F);
    const glm::vec4 clip = clip_of(camera, point);
    EXPECT_NEAR(clip.w, 5.0F, 1e-4F);
    EXPECT_NEAR(clip.x / clip.w, 2.0F * 0.8F - 1.0F, 1e-4F);
    EXPECT_NEAR(clip.y / clip.w, 1.0F - 2.0F * 0.3F, 1e-4F);
}

TEST(ExplorerFlight, FramingShowsEveryCornerOfTheScene) {
    const renderer::Bounds bounds{{-3.0F, -1.0F, 2.0F}, {4.0F, 9.0F, 8.0F}};
    const renderer::Camera camera = framing(turned(ahead(), 1.0F, 0.2F), bounds, 16.0F / 9.0F);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 clip =
            clip_of(camera, {(corner & 1) != 0 ? bounds.high_m.x : bounds.low_m.x,
                             (corner & 2) != 0 ? bounds.high_m.y : bounds.low_m.y,
                             (corner & 4) != 0 ? bounds.high_m.z : bounds.low_m.z});
        EXPECT_LE(std::abs(clip.x), clip.w);
        EXPECT_LE(std::abs(clip.y), clip.w);
        EXPECT_LE(std::abs(clip.z), clip.w);
    }
}

TEST(ExplorerFlight, EveryFlownCameraIsOneThatTheRendererTakes) {
    base::Random random(7);
    renderer::Camera camera = ahead();
    const auto number = [&]() -> float {
        switch (random.below(8)) {
            case 0:
                return std::numeric_limits<float>::quiet_NaN();
            case 1:
                return std::numeric_limits<float>::infinity();
            case 2:
                return static_cast<float>(random.uniform(-1e9, 1e9));
            default:
                return static_cast<float>(random.uniform(-2.0, 2.0));
        }
    };
    for (int i = 0; i < 20000; ++i) {
        switch (random.below(5)) {
            case 0:
                camera = flown(camera, {number(), number(), number()});
                break;
            case 1:
                camera = turned(camera, number(), number());
                break;
            case 2:
                camera = orbited(camera, {number(), number(), number()}, number(), number());
                break;
            case 3:
                camera = with_fov(camera, number() * 100.0F);
                break;
            default:
                camera = framing(camera, {{-1.0F, number(), -1.0F}, {1.0F, number(), 1.0F}}, 1.5F);
        }
        ASSERT_NO_THROW((void)renderer::matrices_of(camera, 16, 9)) << i;
    }
}

}  // namespace
}  // namespace obscura::app::explorer
