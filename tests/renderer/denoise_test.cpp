// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "renderer/denoise/denoise.h"
#include "renderer/gl/context.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

class DenoiseTest : public testing::Test {
  protected:
    Frame render(const Scene& scene, const std::string& technique, const std::string& denoise,
                 std::map<std::string, double> parameters = {}) {
        Variant choice = tests::choice_of(technique, denoise);
        choice.parameters = std::move(parameters);
        const GpuScene gpu(scene);
        return renderer_.render({gpu, {}, tests::forward_camera()}, choice, 256, 256);
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

/// Strength of a pattern that repeats every four or two pixels: the largest of the Fourier
/// components of period 4 and 2 of a series, under a window that ends in zeros.
double periodic_part(const std::vector<double>& series) {
    double strongest = 0.0;
    for (const double step : {0.5 * std::numbers::pi, std::numbers::pi}) {
        std::complex<double> sum = 0.0;
        for (std::size_t i = 0; i < series.size(); ++i) {
            const double at = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) /
                              static_cast<double>(series.size());
            sum += series[i] * (0.5 - 0.5 * std::cos(at)) *
                   std::polar(1.0, step * static_cast<double>(i));
        }
        strongest = std::max(strongest, std::abs(sum) / static_cast<double>(series.size()));
    }
    return strongest;
}

/// The strongest pattern of the 4x4 tile across or down an area of 64 x 32 pixels: every fourth
/// column is averaged over its rows, every row over every fourth of its columns.
double pattern_of(const std::vector<float>& values, int first_row) {
    double strongest = 0.0;
    for (int phase = 0; phase < 4; ++phase) {
        std::vector<double> down(32, 0.0);
        std::vector<double> across(64, 0.0);
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 64; ++x) {
                const double value = values[static_cast<std::size_t>(first_row + y) * 256 + 96 + x];
                if (x % 4 == phase) down[y] += value / 16.0;
                if (y % 4 == phase) across[x] += value / 8.0;
            }
        }
        strongest = std::max({strongest, periodic_part(down), periodic_part(across)});
    }
    return strongest;
}

/// Of the filters, those that know edges.
std::vector<std::string> edge_aware() {
    std::vector<std::string> names;
    for (const Denoise& denoise : denoise_filters()) {
        if (denoise.model && denoise.edge_by_nature.empty()) names.push_back(denoise.name);
    }
    return names;
}

using EdgeAwareDenoise = DenoiseTest;

TEST_F(EdgeAwareDenoise, LeavesNoPatternOfTheTileOnATiltedFloor) {
    const std::map<std::string, double> wide = {{"radius_m", 1.0}, {"power", 8.0}};
    for (const std::string& filter : edge_aware()) {
        const Frame frame = render(corner_scene(), "blizzard", filter, wide);
        const double before = pattern_of(frame.read_floats(Target::kAccessibility), 195);
        const double after = pattern_of(frame.read_floats(Target::kDenoised), 195);
        EXPECT_GT(before, 0.005);
        EXPECT_LT(after, before / 25.0) << filter;
    }
}

TEST_F(EdgeAwareDenoise, NeverLeaksAcrossADepthEdge) {
    // A board tilted away, which blizzard darkens all over, before an open wall far behind it.
    Scene scene = tests::facing_wall(20.0F);
    tests::add_quad(scene, {-1.0F, -1.0F, -4.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 1.0F, -2.5F});
    for (const std::string& filter : edge_aware()) {
        const Frame frame =
            render(scene, "blizzard", filter,
                   {{"radius_m", 0.3}, {"power", 3000.0}, {"full_threshold_m", 0.0}});
        const std::vector<float> depth = frame.read_floats(Target::kDepth);
        const std::vector<float> smooth = frame.read_floats(Target::kDenoised);
        double board = 0.0;
        int pixels = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            if (depth[i] > 15.0F) {
                ASSERT_GE(smooth[i], 0.99F) << filter << ", pixel " << i % 256 << ", " << i / 256;
            } else {
                board += smooth[i];
                ++pixels;
            }
        }
        // A leak of even a tenth of the weights would then show on the wall.
        EXPECT_LT(board / pixels, 0.9) << "the board is not dark: nothing could leak";
    }
}

TEST_F(EdgeAwareDenoise, GaussianNdStopsAtAnEdgeThatOnlyNormalsKnow) {
    // A right angle seen evenly from both sides: depth goes on in it, and normals turn.
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {0.0F, -9.0F, -6.0F}, {9.0F, 0.0F, 9.0F}, {0.0F, 18.0F, 0.0F});
    tests::add_quad(scene, {-9.0F, -9.0F, 3.0F}, {9.0F, 0.0F, -9.0F}, {0.0F, 18.0F, 0.0F});
    const Frame frame = render(scene, "blizzard", "gaussian_nd", {{"radius_m", 0.5}});
    const std::vector<float> raw = frame.read_floats(Target::kAccessibility);
    const std::vector<float> smooth = frame.read_floats(Target::kDenoised);
    for (int y = 40; y < 216; ++y) {
        // What a pixel beside the edge is made of lies within six pixels on its own side.
        float least = 1.0F;
        float most = 0.0F;
        for (int j = -6; j <= 6; ++j) {
            for (int x = 128; x < 136; ++x) {
                const float value = raw[static_cast<std::size_t>(y + j) * 256 + x];
                least = std::min(least, value);
                most = std::max(most, value);
            }
        }
        const float value = smooth[static_cast<std::size_t>(y) * 256 + 129];
        ASSERT_GE(value, least - 1e-5F) << y;
        ASSERT_LE(value, most + 1e-5F) << y;
    }
}

TEST_F(DenoiseTest, EveryFilterKeepsAnEvenBufferAndTheEmptyPixels) {
    for (const Denoise& denoise : denoise_filters()) {
        if (denoise.recipe.steps.empty()) continue;
        const Frame frame = render(tests::facing_wall(5.0F), "blizzard", denoise.name);
        for (const float value : frame.read_floats(Target::kDenoised)) {
            // GLSL lets a division be 2.5 units of the last place off (4.7.1), each of two passes.
            ASSERT_GE(value, 1.0F - 6.0e-7F) << denoise.name;
            ASSERT_LE(value, 1.0F) << denoise.name;
        }
    }
}

TEST_F(DenoiseTest, PixelsThatShareATexelAreReadInTheirPlacesAtAnOddWidth) {
    const Scene scene = corner_scene();
    const GpuScene gpu(scene);
    const Frame frame = renderer_.render({gpu, {}, tests::forward_camera()},
                                         tests::choice_of("blizzard", "separable"), 67, 41);
    EXPECT_EQ(frame.plan().find("denoise step")->width, 34);
    EXPECT_EQ(frame.plan().find(Target::kDenoised)->width, 34);
    const std::vector<float> depth_m = frame.read_floats(Target::kDepth);
    const std::vector<float> step = frame.read_components("denoise step", 2);
    ASSERT_EQ(step.size(), 2U * 67U * 41U);
    for (std::size_t i = 0; i < depth_m.size(); ++i) {
        ASSERT_NEAR(step[2 * i + 1] * depth_m[i], 1.0F, 1e-6F) << i % 67 << ", " << i / 67;
    }
    EXPECT_EQ(frame.read_accessibility().size(), depth_m.size());
}

TEST_F(DenoiseTest, Box4TakesTheTileAwayFromAFloor) {
    const Frame frame =
        render(corner_scene(), "blizzard", "box4", {{"radius_m", 1.0}, {"power", 8.0}});
    EXPECT_LT(pattern_of(frame.read_floats(Target::kDenoised), 195),
              pattern_of(frame.read_floats(Target::kAccessibility), 195) / 10.0);
}

}  // namespace
}  // namespace obscura::renderer
