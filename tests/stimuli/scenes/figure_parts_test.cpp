// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/parts.h"
#include "tests/stimuli/scenes/mesh_soundness.h"

namespace obscura::stimuli {
namespace {

Sculpture ball_of_10_cm() {
    Sculpture solid;
    solid.add(ball({0.0F, 0.0F, 0.0F}, 0.10F));
    return solid;
}

/// Closed, turned outwards, and no part further above the ball than it is thick.
void expect_lies_on_the_ball(const renderer::Mesh& mesh, float thick_m) {
    expect_sound(mesh);
    EXPECT_TRUE(open_edges(mesh).empty());
    EXPECT_TRUE(turned_triangles(mesh).empty());
    float highest = -1.0F;
    for (const renderer::Vertex& vertex : mesh.vertices) {
        highest = std::max(highest, glm::length(vertex.position_m) - 0.10F);
    }
    EXPECT_NEAR(highest, thick_m, 0.0012F);
}

TEST(Overlay, AStrapIsClosedAndLiesOnItsSolid) {
    const figures::OverlayStyle style{.columns = 4, .rows = 16, .thick_m = 0.004F, .stiff = 0};
    const auto strap =
        figures::along_path({{-0.05F, 0.0F, 0.2F}, {0.0F, 0.0F, 0.2F}, {0.05F, 0.0F, 0.2F}},
                            {0.0F, 0.0F, -1.0F}, 0.03F);
    expect_lies_on_the_ball(figures::overlay(ball_of_10_cm(), style, strap), 0.004F);
}

TEST(Overlay, ABeltGoesAllRound) {
    const figures::OverlayStyle style{
        .columns = 4, .rows = 48, .thick_m = 0.005F, .stiff = 0, .ring = true};
    const auto belt = figures::around_body({}, {0.0F, 0.0F, 0.0F}, {0.15F, 0.15F}, 0.03F, 0.0F);
    const renderer::Mesh mesh = figures::overlay(ball_of_10_cm(), style, belt);
    expect_lies_on_the_ball(mesh, 0.005F);
    for (const glm::vec3& way : {glm::vec3(0.10F, 0.0F, 0.0F), glm::vec3(0.0F, 0.0F, -0.10F)}) {
        float nearest = 1.0F;
        for (const renderer::Vertex& vertex : mesh.vertices) {
            nearest = std::min(nearest, glm::distance(vertex.position_m, way));
        }
        EXPECT_LT(nearest, 0.015F);
    }
}

TEST(FaceForm, IsClosedFromForeheadToChin) {
    Sculpture face;
    face.add(figures::face_form({}, 1.0F, {}));
    const renderer::Mesh mesh = polygonise(face, 0.0025F);
    expect_sound(mesh);
    EXPECT_TRUE(open_edges(mesh).empty());
}

TEST(Hairline, LiesLowerAtTheNapeThanAtTheForehead) {
    for (const auto& line : {figures::short_hairline, figures::long_hairline}) {
        EXPECT_GT(line(0.0F), line(1.3F));
        EXPECT_GT(line(1.3F), line(3.1F));
    }
}

TEST(SlackCable, IsClosedAndRunsThroughItsPoints) {
    constexpr float kRadius_m = 0.01F;
    const std::array<glm::vec3, 4> through{
        {{0.0F, 1.0F, 0.0F}, {0.1F, 0.9F, 0.0F}, {0.15F, 0.1F, 0.0F}, {0.6F, 0.01F, 0.1F}}};
    const renderer::Mesh mesh = slack_cable(through, kRadius_m);
    expect_sound(mesh);
    EXPECT_TRUE(open_edges(mesh).empty());
    for (const glm::vec3& point : through) {
        float nearest = 1.0F;
        for (const renderer::Vertex& vertex : mesh.vertices) {
            nearest = std::min(nearest, glm::distance(vertex.position_m, point));
        }
        EXPECT_LE(nearest, 1.01F * kRadius_m);
    }
}

}  // namespace
}  // namespace obscura::stimuli
