// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "renderer/reference/closed_forms.h"
#include "tests/renderer/reference/corner.h"

namespace obscura::renderer {
namespace {

using tests::CornerView;
using tests::rays_within;

/// A floor under a ceiling whose surface the test sets; the camera looks at the floor from between.
CornerView under_ceiling(const Material& ceiling) {
    CornerView view;
    view.camera.position_m = {0.3F, 0.3F, 0.0F};
    view.camera.target_m = {0.0F, 0.0F, 0.0F};
    view.camera.vertical_fov_rad = 0.01F;
    add_floor(view.scene, -20.0, 40.0);
    add_parallelogram(view.scene, {-20.0, 0.5, -20.0}, {40.0, 0.0, 0.0}, {0.0, 0.0, 40.0});
    std::size_t i = 0;
    for (Vertex& vertex : view.scene.meshes[1].vertices) {
        vertex.uv = {i % 2 == 0 ? 0.0F : 4000.0F, i / 2 == 0 ? 0.0F : 4000.0F};
        ++i;
    }
    view.scene.materials.push_back(ceiling);
    view.scene.meshes[1].material = 1;
    return view;
}

double mean_under(const CornerView& view) {
    return tests::mean_of(
        ReferenceScene(view.scene).trace(view.camera, 16, 16, rays_within(1.0, 256)).accessibility);
}

Texture stripes(std::uint8_t even, std::uint8_t odd) {
    Texture texture;
    texture.name = "stripes";
    texture.width = 2;
    texture.height = 1;
    texture.rgba = {255, 255, 255, even, 255, 255, 255, odd};
    return texture;
}

TEST(ReferenceSurfaces, ATriangleOccludesFromBothSides) {
    Material single;
    single.double_sided = false;
    CornerView view = under_ceiling(single);
    EXPECT_NEAR(mean_under(view), between_plates(0.5), 1e-3);
    for (std::size_t i = 0; i < view.scene.meshes[1].indices.size(); i += 3) {
        std::swap(view.scene.meshes[1].indices[i], view.scene.meshes[1].indices[i + 1]);
    }
    EXPECT_NEAR(mean_under(view), between_plates(0.5), 1e-3);
}

TEST(ReferenceSurfaces, TheCameraDoesNotSeeTheBackOfASingleSidedTriangle) {
    CornerView view;
    add_floor(view.scene, 0.0, 8.0);
    add_parallelogram(view.scene, {0.0, 0.5, -8.0}, {0.0, 0.0, 16.0}, {8.0, 0.0, 0.0});
    Material single;
    single.double_sided = false;
    view.scene.materials.push_back(single);
    view.scene.meshes[1].material = 1;
    const auto depth = [&view] {
        return ReferenceScene(view.scene)
            .trace(view.camera, 1, 1, rays_within(1.0, 4))
            .depth_m.front();
    };
    const float front = depth();
    for (std::size_t i = 0; i < view.scene.meshes[1].indices.size(); i += 3) {
        std::swap(view.scene.meshes[1].indices[i], view.scene.meshes[1].indices[i + 1]);
    }
    const float back = depth();
    EXPECT_NEAR(front / back, 2.0 / 3.0, 1e-5);
    view.scene.materials[1].double_sided = true;
    EXPECT_EQ(depth(), front);
}

TEST(ReferenceSurfaces, ASurfaceBelowItsCutoffIsNotThere) {
    Material ceiling;
    ceiling.double_sided = true;
    ceiling.coverage = Coverage::kCutOut;
    ceiling.opacity = 0.49F;
    EXPECT_EQ(mean_under(under_ceiling(ceiling)), 1.0);
    ceiling.opacity = 0.5F;
    EXPECT_NEAR(mean_under(under_ceiling(ceiling)), between_plates(0.5), 1e-3);
    ceiling.coverage = Coverage::kOpaque;
    ceiling.opacity = 0.0F;
    EXPECT_NEAR(mean_under(under_ceiling(ceiling)), between_plates(0.5), 1e-3);
}

TEST(ReferenceSurfaces, ABlendedSurfaceDoesNotOcclude) {
    Material ceiling;
    ceiling.coverage = Coverage::kBlended;
    EXPECT_EQ(mean_under(under_ceiling(ceiling)), 1.0);
}

// A texel of alpha 1 beside one of alpha 0, filtered bilinearly: a cutoff of 1/2 leaves half of the
// surface, one of 1/4 three quarters of it.
TEST(ReferenceSurfaces, HolesTakeTheShareOfTheSurfaceThatTheFilteredTextureSays) {
    Material ceiling;
    ceiling.double_sided = true;
    ceiling.coverage = Coverage::kCutOut;
    ceiling.albedo_texture = 0;
    const double covered = 1.0 - between_plates(0.5);
    for (const double cutoff : {0.25, 0.5, 0.75}) {
        ceiling.alpha_cutoff = static_cast<float>(cutoff);
        CornerView view = under_ceiling(ceiling);
        view.scene.textures.push_back(stripes(255, 0));
        EXPECT_NEAR(mean_under(view), 1.0 - covered * (1.0 - cutoff), 3e-3) << cutoff;
    }
}

TEST(ReferenceSurfaces, OpacityScalesTheTexturesAlpha) {
    Material ceiling;
    ceiling.double_sided = true;
    ceiling.coverage = Coverage::kCutOut;
    ceiling.albedo_texture = 0;
    ceiling.opacity = 0.4F;
    CornerView view = under_ceiling(ceiling);
    view.scene.textures.push_back(stripes(255, 255));
    EXPECT_EQ(mean_under(view), 1.0);
}

TEST(ReferenceSurfaces, HolesCountForFalloffToo) {
    Material ceiling;
    ceiling.double_sided = true;
    ceiling.coverage = Coverage::kCutOut;
    ceiling.opacity = 0.1F;
    const CornerView view = under_ceiling(ceiling);
    ReferenceOptions options = rays_within(1.0, 64);
    options.falloff = Falloff::kLinear;
    const ReferenceImage image = ReferenceScene(view.scene).trace(view.camera, 4, 4, options);
    EXPECT_THAT(image.accessibility, testing::Each(1.0F));
}

TEST(ReferenceSurfaces, CoverageChangesTheGeometrysHash) {
    Material ceiling;
    const std::string opaque = ReferenceScene(under_ceiling(ceiling).scene).geometry_sha256();
    EXPECT_EQ(ReferenceScene(under_ceiling(ceiling).scene).geometry_sha256(), opaque);
    ceiling.coverage = Coverage::kCutOut;
    const std::string cut = ReferenceScene(under_ceiling(ceiling).scene).geometry_sha256();
    EXPECT_NE(cut, opaque);
    ceiling.opacity = 0.7F;
    EXPECT_NE(ReferenceScene(under_ceiling(ceiling).scene).geometry_sha256(), cut);
}

// A normal turned by 60 degrees from an open floor: what lies below the floor is occluded, which
// leaves a wedge of 120 degrees.
TEST(ReferenceSurfaces, DirectionsBelowTheSurfaceOfATurnedNormalAreOccluded) {
    CornerView view;
    view.camera.position_m = {0.3F, 0.3F, 0.0F};
    view.camera.target_m = {0.0F, 0.0F, 0.0F};
    view.camera.vertical_fov_rad = 0.01F;
    add_floor(view.scene, -20.0, 40.0);
    const double turn = std::numbers::pi / 3.0;
    for (Vertex& vertex : view.scene.meshes[0].vertices) {
        vertex.normal = {static_cast<float>(std::sin(turn)), static_cast<float>(std::cos(turn)), 0};
    }
    ReferenceOptions options = rays_within(1.0, 1024);
    options.normal = NormalKind::kShading;
    const ReferenceImage image = ReferenceScene(view.scene).trace(view.camera, 8, 8, options);
    EXPECT_NEAR(tests::mean_of(image.accessibility), wedge(std::numbers::pi - turn), 1e-3);
}

// Vertex normals that point into the floor (some writers turn them round): the truth is that of the
// same normals outwards, from either side of the floor, and not that nothing is open.
TEST(ReferenceSurfaces, NormalsOnTheWrongSideOfTheirFaceAreTurnedTowardsTheCamera) {
    for (const float side : {1.0F, -1.0F}) {
        CornerView view;
        view.camera.position_m = {0.3F, 0.3F * side, 0.0F};
        view.camera.target_m = {0.0F, 0.0F, 0.0F};
        view.camera.vertical_fov_rad = 0.01F;
        add_floor(view.scene, -20.0, 40.0);
        Material both_sides;
        both_sides.double_sided = true;
        view.scene.materials = {both_sides};
        ReferenceOptions options = rays_within(1.0, 256);
        options.normal = NormalKind::kShading;
        std::vector<std::vector<float>> images;
        for (const float turned : {1.0F, -1.0F}) {
            for (Vertex& vertex : view.scene.meshes[0].vertices) {
                vertex.normal = turned * glm::vec3(0.6F, 0.8F, 0.0F);
            }
            images.push_back(
                ReferenceScene(view.scene).trace(view.camera, 4, 4, options).accessibility);
        }
        EXPECT_EQ(images[0], images[1]) << side;
        EXPECT_NEAR(tests::mean_of(images[1]), wedge(std::numbers::pi - std::acos(0.8)), 5e-3);
    }
}

}  // namespace
}  // namespace obscura::renderer
