// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/denoise/denoise.h"
#include "renderer/gl/context.h"
#include "tests/test_scenes.h"

namespace obscura::renderer {
namespace {

class DenoiseTest : public testing::Test {
  protected:
    Frame render(const Scene& scene, const std::string& technique, const std::string& denoise,
                 std::map<std::string, double> parameters = {}) {
        TechniqueChoice choice;
        choice.technique = technique;
        choice.samples = find_technique(technique)->samples.standard;
        choice.parameters = std::move(parameters);
        choice.denoise = denoise;
        const GpuScene gpu(scene);
        return renderer_.render(gpu, {}, tests::forward_camera(), choice,
                                plan_frame(needs_of(scene, {}), choice, 256, 256));
    }
    HeadlessContext context_;
    Renderer renderer_;
};

/// A floor that runs away from the camera and meets a wall: blizzard's noise lies on the floor.
Scene corner_scene() {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-20.0F, -1.0F, -6.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 20.0F, 0.0F});
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -6.0F});
    return scene;
}

/// How much values that lie four pixels apart agree more than their neighbours do: the spread of
/// the means of the four columns of the tile, over the middle of the image.
double pattern_of(const std::vector<float>& values, int first_row, int last_row) {
    double worst = 0.0;
    for (int y = first_row; y < last_row; ++y) {
        double sum[4] = {};
        for (int x = 64; x < 192; ++x) sum[x % 4] += values[static_cast<std::size_t>(y) * 256 + x];
        for (const double a : sum) {
            for (const double b : sum) worst = std::max(worst, (a - b) / 32.0);
        }
    }
    return worst;
}

TEST_F(DenoiseTest, SeparableLeavesNoPatternOfTheTileOnATiltedFloor) {
    const std::map<std::string, double> wide = {{"radius_m", 1.0}, {"power", 8.0}};
    const Frame frame = render(corner_scene(), "blizzard", "separable", wide);
    const double before = pattern_of(frame.read_floats(Target::kAccessibility), 190, 230);
    const double after = pattern_of(frame.read_floats(Target::kDenoised), 190, 230);
    EXPECT_GT(before, 0.01);
    EXPECT_LT(after, before / 50.0);
}

TEST_F(DenoiseTest, SeparableNeverLeaksAcrossADepthEdge) {
    // A dark box before an open wall 10 radii behind it.
    Scene scene = tests::facing_wall(20.0F);
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 1.0F, -5.0F});
    const Frame frame = render(scene, "blizzard", "separable", {{"no_threshold_m", 2.0}});
    const std::vector<float> depth = frame.read_floats(Target::kDepth);
    const std::vector<float> smooth = frame.read_floats(Target::kDenoised);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (depth[i] > 15.0F) {
            ASSERT_GE(smooth[i], 0.99F) << "pixel " << i % 256 << ", " << i / 256;
        }
    }
}

TEST_F(DenoiseTest, EveryFilterKeepsAnEvenBufferAndTheEmptyPixels) {
    for (const Denoise& denoise : denoise_filters()) {
        if (denoise.passes == 0) continue;
        const Frame frame = render(tests::facing_wall(5.0F), "blizzard", denoise.name);
        for (const float value : frame.read_floats(Target::kDenoised)) {
            ASSERT_EQ(value, 1.0F) << denoise.name;
        }
    }
}

TEST_F(DenoiseTest, Box4TakesTheTileAwayFromAnEvenWall) {
    const Frame frame = render(corner_scene(), "crytek", "box4", {{"offset_scale", 0.005}});
    const std::vector<float> raw = frame.read_floats(Target::kAccessibility);
    const std::vector<float> smooth = frame.read_floats(Target::kDenoised);
    EXPECT_LE(pattern_of(smooth, 40, 100), pattern_of(raw, 40, 100) + 1e-7);
    EXPECT_NEAR(smooth[128 * 256 + 128], 0.75F, 1e-3F);
}

}  // namespace
}  // namespace obscura::renderer
