// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/base/error.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/reference.h"
#include "stimuli/scenes/builtin_scene.h"
#include "tests/renderer/reference/corner.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

Variant reference_choice(const std::string& denoise = "none") {
    Variant choice;
    choice.technique = "reference";
    choice.samples = 32;
    choice.denoise = denoise;
    return choice;
}

class ReferenceFrame : public testing::Test {
  protected:
    Frame render(const Scene& scene, const Camera& camera, const Variant& choice, int width,
                 int height) {
        const Lighting lighting;
        const GpuScene gpu(scene);
        const ReferenceScene reference(scene);
        const auto traced = [&](const Camera& view, int w, int h, const Variant& wanted) {
            return reference.trace(view, w, h, reference_options(wanted)).accessibility;
        };
        return renderer_.render({gpu, lighting, camera, {}, traced}, choice, width, height);
    }

    HeadlessContext context_;
    Renderer renderer_;
};

/// A pixel beside a jump in depth: a silhouette, where the rasteriser's snapped corners may decide
/// otherwise.
bool beside_jump(const std::vector<float>& depth_m, int width, int height, int x, int y) {
    const float here = depth_m[static_cast<std::size_t>(y) * width + x];
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int u = x + dx;
            const int v = y + dy;
            if (u < 0 || v < 0 || u >= width || v >= height) continue;
            const float there = depth_m[static_cast<std::size_t>(v) * width + u];
            if (std::abs(there - here) > 0.02F * here) return true;
        }
    }
    return false;
}

TEST_F(ReferenceFrame, SeesTheSameSurfaceAsTheRasteriserInEveryPixelButSilhouettes) {
    constexpr int kWidth = 320;
    constexpr int kHeight = 180;
    const Scene scene = stimuli::find_builtin_scene("atrium")->build();
    const Camera& camera = scene.cameras.front();
    Variant deep;
    deep.technique = "crytek";
    deep.samples = 8;
    const std::vector<float> raster =
        render(scene, camera, deep, kWidth, kHeight).read_floats(Target::kDepth);
    const std::vector<float> traced =
        ReferenceScene(scene).trace(camera, kWidth, kHeight, tests::rays_within(0.5, 1)).depth_m;
    int inside = 0;
    int apart = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * kWidth + x;
            if (beside_jump(raster, kWidth, kHeight, x, y)) continue;
            ++inside;
            const bool empty = raster[i] >= kBackgroundLimit_m;
            if (empty ? traced[i] < kBackgroundLimit_m
                      : std::abs(traced[i] / raster[i] - 1.0F) > 1e-4F) {
                ++apart;
            }
        }
    }
    EXPECT_GT(inside, kWidth * kHeight / 2);
    // Creases whose jump is small remain: one pixel in a thousand.
    EXPECT_LE(apart, inside / 1000);
}

TEST_F(ReferenceFrame, HoldsTheTracedValuesAndOpenEmptyPixels) {
    Scene scene = tests::empty_scene();
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 1.0F, -4.0F});
    tests::add_quad(scene, {-1.5F, -1.0F, -6.0F}, {3.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 3.0F});
    for (Material& material : scene.materials) material.double_sided = true;
    const Camera camera = tests::forward_camera();
    const Variant choice = reference_choice();
    const Frame frame = render(scene, camera, choice, 80, 45);
    const std::vector<float> shown = frame.read_floats(Target::kAccessibility);
    const ReferenceImage truth =
        ReferenceScene(scene).trace(camera, 80, 45, reference_options(choice));
    int occluded = 0;
    int different = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (shown[i] < 1.0F) ++occluded;
        if (shown[i] != truth.accessibility[i]) ++different;
    }
    EXPECT_GT(occluded, 20);
    EXPECT_LT(different, 20);  // silhouettes
    EXPECT_EQ(shown.front(), 1.0F);
}

TEST_F(ReferenceFrame, CanBeDenoisedAndIsThenPlannedWithDepth) {
    for (const char* denoise : {"box4", "separable"}) {
        const Frame frame = render(tests::facing_wall(3.0F), tests::forward_camera(),
                                   reference_choice(denoise), 32, 24);
        EXPECT_THAT(frame.read_floats(Target::kDenoised), testing::Each(testing::Eq(1.0F)));
    }
}

TEST_F(ReferenceFrame, WithoutARayTracerIsAFailureAndNotABlankImage) {
    const Scene scene = tests::facing_wall(3.0F);
    const GpuScene gpu(scene);
    const Lighting lighting;
    const Variant choice = reference_choice();
    EXPECT_THROW((void)renderer_.render({gpu, lighting, tests::forward_camera()}, choice, 8, 8),
                 base::Error);
}

TEST(ReferenceTechnique, TakesWholeNumbersOnlyWhereANumberCounts) {
    Variant choice = reference_choice();
    choice.parameters = {{"falloff", 1.5}};
    EXPECT_EQ(problems_of(choice).size(), 1U);
    choice.parameters = {
        {"falloff", 2.0}, {"seed", 7.0}, {"shading_normal", 1.0}, {"radius_m", 0.25}};
    EXPECT_TRUE(problems_of(choice).empty());
    const ReferenceOptions options = reference_options(choice);
    EXPECT_EQ(options.falloff, Falloff::kQuadratic);
    EXPECT_EQ(options.seed, 7U);
    EXPECT_EQ(options.normal, NormalKind::kShading);
    EXPECT_EQ(options.radius_m, 0.25);
    EXPECT_EQ(options.rays, 32);
}

}  // namespace
}  // namespace obscura::renderer
