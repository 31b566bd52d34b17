// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/closed_forms.h"
#include "tests/renderer/reference/corner.h"

namespace obscura::renderer {
namespace {

using tests::corner_view;
using tests::CornerView;
using tests::rays_within;
using tests::transformed;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// A plane through the middle of the view, turned by that angle, of many small and a few large
/// triangles, `distance_m` ahead of a camera at the origin.
CornerView tilted_plane(double tilt_deg, double distance_m, int cells) {
    CornerView view;
    view.camera.position_m = glm::vec3(0.0F);
    view.camera.target_m = {0.0F, 0.0F, -1.0F};
    view.camera.near_m = static_cast<float>(1e-3 * distance_m);
    view.camera.far_m = static_cast<float>(1e4 * distance_m);
    const double tilt = tilt_deg * std::numbers::pi / 180.0;
    const double reach = 8.0 * distance_m;
    const glm::dvec3 u(1.0, 0.0, 0.0);
    const glm::dvec3 v(0.0, std::cos(tilt), std::sin(tilt));
    const glm::dvec3 middle(0.0, 0.0, -distance_m);
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            const double step = 2.0 * reach / cells;
            add_parallelogram(view.scene, middle + (i * step - reach) * u + (j * step - reach) * v,
                              step * u, step * v);
        }
    }
    return view;
}

TEST(ReferenceOnHardGeometry, APlaneIsExactlyOpenAtEveryDistanceTiltAndPlace) {
    for (const double distance_m : {1e-3, 1.0, 5000.0}) {
        for (const double tilt_deg : {0.0, 45.0, 80.0, 89.0}) {
            for (const int cells : {1, 7}) {
                const CornerView view = tilted_plane(tilt_deg, distance_m, cells);
                const ReferenceImage image =
                    ReferenceScene(view.scene)
                        .trace(view.camera, 16, 16, rays_within(distance_m, 256));
                // The corners of the plane are floats: neighbours meet in creases of 1e-7.
                EXPECT_THAT(image.accessibility, testing::Each(testing::Ge(0.9999F)))
                    << distance_m << " m, " << tilt_deg << " degrees, " << cells;
                EXPECT_GT(tests::mean_of(image.accessibility), 0.99999);
            }
        }
    }
}

TEST(ReferenceOnHardGeometry, APlaneFarFromTheOriginIsOpen) {
    CornerView view = corner_view();
    view.scene.meshes.pop_back();
    for (const glm::vec3& move :
         {glm::vec3(131072.0F, 0.0F, 0.0F), glm::vec3(-131072.0F, 131072.0F, 131072.0F)}) {
        const CornerView far = transformed(view, 1.0F, move);
        const ReferenceImage image =
            ReferenceScene(far.scene).trace(far.camera, 24, 24, rays_within(1.0, 256));
        EXPECT_THAT(image.accessibility, testing::Each(testing::Eq(1.0F)));
    }
}

TEST(ReferenceOnHardGeometry, ACornerIsTheSameFarFromTheOrigin) {
    const CornerView near = corner_view();
    // A power of two, so that the moved corners are exact in floats.
    const CornerView far = transformed(near, 1.0F, {131072.0F, -131072.0F, 131072.0F});
    const ReferenceOptions options = rays_within(1.0, 256);
    const ReferenceImage one = ReferenceScene(near.scene).trace(near.camera, 32, 32, options);
    const ReferenceImage two = ReferenceScene(far.scene).trace(far.camera, 32, 32, options);
    EXPECT_LT(tests::greatest_difference(one, two), 0.02);
    EXPECT_NEAR(tests::mean_of(one.accessibility), tests::mean_of(two.accessibility), 2e-4);
}

TEST(ReferenceOnHardGeometry, ACornerIsTheSameInMillimetresAndKilometres) {
    const CornerView metres = corner_view();
    const ReferenceImage one =
        ReferenceScene(metres.scene).trace(metres.camera, 32, 32, rays_within(1.0, 256));
    for (const float scale : {1e-3F, 1e3F}) {
        const CornerView other = transformed(metres, scale, glm::vec3(0.0F));
        const ReferenceImage two =
            ReferenceScene(other.scene).trace(other.camera, 32, 32, rays_within(scale, 256));
        EXPECT_LT(tests::greatest_difference(one, two), 0.02) << scale;
        EXPECT_NEAR(tests::mean_of(one.accessibility), tests::mean_of(two.accessibility), 2e-4)
            << scale;
    }
}

TEST(ReferenceOnHardGeometry, AContactOfATenThousandthOfTheRadiusIsNotMissed) {
    CornerView view = corner_view();
    view.camera.position_m = {0.3F, 0.2F, 0.0F};
    view.camera.target_m = {1e-4F, 0.0F, 0.0F};
    view.camera.vertical_fov_rad = 1.1e-3F;
    view.camera.position_m = {1e-4F + 0.01F, 0.01F, 0.0F};
    view.camera.near_m = 1e-4F;
    const ReferenceImage image =
        ReferenceScene(view.scene).trace(view.camera, 8, 8, rays_within(1.0, 1024));
    EXPECT_NEAR(tests::mean_of(image.accessibility), corner_within_radius(1e-4), 1e-3);
}

TEST(ReferenceOnHardGeometry, TrianglesWithoutAreaOrWithNaNAreLeftOutAndCounted) {
    CornerView view = corner_view();
    const ReferenceOptions options = rays_within(1.0, 64);
    const ReferenceImage clean = ReferenceScene(view.scene).trace(view.camera, 24, 24, options);
    for (const glm::vec3& bad :
         {glm::vec3(kNan, 0.1F, 0.0F), glm::vec3(0.5F, kInf, 0.0F), glm::vec3(0.5F, 0.2F, 0.0F)}) {
        Mesh mesh = view.scene.meshes.front();
        for (Vertex& vertex : mesh.vertices) vertex.position_m = {0.5F, 0.2F, 0.0F};
        mesh.vertices[0].position_m = bad;
        mesh.indices = {0, 1, 2};
        view.scene.meshes.push_back(mesh);
    }
    const ReferenceScene scene(view.scene);
    EXPECT_EQ(scene.skipped_triangles(), 3U);
    const ReferenceImage image = scene.trace(view.camera, 24, 24, options);
    EXPECT_EQ(image.accessibility, clean.accessibility);
    EXPECT_EQ(image.depth_m, clean.depth_m);
}

TEST(ReferenceOnHardGeometry, NormalsThatAreNoneLeaveTheTrianglesOwn) {
    CornerView view = corner_view();
    ReferenceOptions options = rays_within(1.0, 64);
    const ReferenceImage geometric = ReferenceScene(view.scene).trace(view.camera, 24, 24, options);
    options.normal = NormalKind::kShading;
    for (const glm::vec3& normal : {glm::vec3(0.0F), glm::vec3(kNan), glm::vec3(kInf)}) {
        for (Mesh& mesh : view.scene.meshes) {
            for (Vertex& vertex : mesh.vertices) vertex.normal = normal;
        }
        EXPECT_EQ(ReferenceScene(view.scene).trace(view.camera, 24, 24, options).accessibility,
                  geometric.accessibility);
    }
}

TEST(ReferenceOnHardGeometry, CoincidentFacesDoNotOccludeEachOther) {
    CornerView view;
    add_floor(view.scene, 0.0, 8.0);
    add_floor(view.scene, 0.0, 8.0);
    const ReferenceImage image =
        ReferenceScene(view.scene).trace(view.camera, 24, 24, rays_within(1.0, 64));
    EXPECT_THAT(image.accessibility, testing::Each(1.0F));
}

TEST(ReferenceOnHardGeometry, ACameraInsideGeometryGivesAFiniteImage) {
    CornerView view;
    add_ball(view.scene, glm::dvec3(view.camera.position_m), 1.0, 16);
    const ReferenceImage image =
        ReferenceScene(view.scene).trace(view.camera, 24, 24, rays_within(10.0, 64));
    // From inside a closed ball every ray meets it.
    EXPECT_THAT(image.accessibility, testing::Each(0.0F));
    for (Material& material : view.scene.materials) material.double_sided = false;
    const ReferenceImage culled =
        ReferenceScene(view.scene).trace(view.camera, 24, 24, rays_within(10.0, 64));
    for (const float value : culled.accessibility) EXPECT_TRUE(value == 0.0F || value == 1.0F);
}

TEST(ReferenceOnHardGeometry, ASceneWithNothingToMeetIsBadInput) {
    const auto code_of = [](const Scene& scene) {
        try {
            const ReferenceScene reference(scene);
        } catch (const base::Error& error) {
            return error.code();
        }
        return base::ExitCode::kDone;
    };
    CornerView view;
    EXPECT_EQ(code_of(view.scene), base::ExitCode::kBadInput);
    EXPECT_EQ(code_of(Scene{}), base::ExitCode::kBadInput);
    add_floor(view.scene, 0.0, 1.0);
    EXPECT_EQ(code_of(view.scene), base::ExitCode::kDone);
    for (Vertex& vertex : view.scene.meshes[0].vertices) vertex.position_m.y = kNan;
    EXPECT_EQ(code_of(view.scene), base::ExitCode::kBadInput);
}

TEST(ReferenceOnHardGeometry, NumbersThatPointNowhereAreBadInput) {
    CornerView view = corner_view();
    Scene index = view.scene;
    index.meshes[0].indices[0] = 1000;
    EXPECT_THROW(ReferenceScene{index}, base::Error);
    Scene material = view.scene;
    material.meshes[0].material = 7;
    EXPECT_THROW(ReferenceScene{material}, base::Error);
    Scene texture = view.scene;
    texture.materials[0].coverage = Coverage::kCutOut;
    texture.materials[0].albedo_texture = 3;
    EXPECT_THROW(ReferenceScene{texture}, base::Error);
}

}  // namespace
}  // namespace obscura::renderer
