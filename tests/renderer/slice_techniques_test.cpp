// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/slices.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using tests::choice_of;
using tests::forward_camera;

constexpr int kSlicePixels = 128;

class SliceTechniques : public testing::TestWithParam<std::string> {
  protected:
    Frame render(const Scene& scene, const Variant& choice) {
        const Lighting lighting;
        const GpuScene gpu(scene);
        return renderer_.render({gpu, lighting, forward_camera()}, choice, kSlicePixels,
                                kSlicePixels);
    }

    std::vector<float> accessibility(const Scene& scene, const Variant& choice) {
        return render(scene, choice).read_floats(Target::kAccessibility);
    }

    HeadlessContext context_;
    Renderer renderer_;
};

/// A plane through a point before the camera, its far end leaning away.
Scene tilted_plane(float distance_m, float tilt_rad) {
    Scene scene = tests::empty_scene();
    const float half_m = 500.0F * distance_m;
    const glm::vec3 up(0.0F, std::cos(tilt_rad), -std::sin(tilt_rad));
    tests::add_quad(scene, glm::vec3(-half_m, 0.0F, -distance_m) - half_m * up,
                    {2.0F * half_m, 0.0F, 0.0F}, 2.0F * half_m * up);
    return scene;
}

/// A wall 6 m away whose left end meets another that comes towards the camera.
Scene corner() {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-1.0F, -50.0F, -6.0F}, {100.0F, 0.0F, 0.0F}, {0.0F, 100.0F, 0.0F});
    tests::add_quad(scene, {-1.0F, -50.0F, 50.0F}, {0.0F, 0.0F, -56.0F}, {0.0F, 100.0F, 0.0F});
    return scene;
}

/// Means of four columns of the wall 6 m away, over rows in the middle, with the distance from the
/// corner in metres.
std::vector<std::pair<double, double>> profile(const std::vector<float>& open) {
    const double half_m = 6.0 * std::tan(std::numbers::pi / 6.0);
    std::vector<std::pair<double, double>> means;
    for (int column = 0; column + 4 <= kSlicePixels; column += 4) {
        const double from_corner_m = (2.0 * (column + 2) / kSlicePixels - 1.0) * half_m + 1.0;
        if (from_corner_m < 0.1) continue;
        double sum = 0.0;
        for (int y = 48; y < 80; ++y) {
            for (int x = column; x < column + 4; ++x) {
                sum += open[static_cast<std::size_t>(y) * kSlicePixels + x];
            }
        }
        means.emplace_back(from_corner_m, sum / (4.0 * 32.0));
    }
    return means;
}

TEST_P(SliceTechniques, APlaneIsOpenAtAnyTilt) {
    for (const float tilt_deg : {0.0F, 30.0F, 45.0F, 60.0F, 75.0F, 85.0F}) {
        for (const float distance_m : {0.5F, 5.0F, 50.0F}) {
            Variant choice = choice_of(GetParam());
            choice.parameters["radius_m"] = 0.2 * distance_m;
            const Frame frame = render(tilted_plane(distance_m, glm::radians(tilt_deg)), choice);
            const std::vector<float> open = frame.read_floats(Target::kAccessibility);
            EXPECT_GE(*std::min_element(open.begin(), open.end()), 0.999F)
                << tilt_deg << " degrees, " << distance_m << " m";
            EXPECT_LE(*std::max_element(open.begin(), open.end()), 1.0F);
        }
    }
}

TEST_P(SliceTechniques, ALargerRadiusNeverOpensACorner) {
    double before = 2.0;
    for (const double radius_m : {0.25, 0.5, 1.0, 2.0}) {
        Variant choice = choice_of(GetParam());
        choice.samples = 64;
        choice.parameters["radius_m"] = radius_m;
        double mean = 0.0;
        const auto means = profile(accessibility(corner(), choice));
        for (const auto& [from_corner_m, open] : means) mean += open / means.size();
        EXPECT_LT(mean, before) << radius_m;
        before = mean;
    }
}

TEST_P(SliceTechniques, WhatIsFartherThanTheRadiusDoesNotOcclude) {
    Variant choice = choice_of(GetParam());
    choice.parameters["radius_m"] = 0.5;
    for (const auto& [from_corner_m, open] : profile(accessibility(corner(), choice))) {
        if (from_corner_m > 0.6) {
            EXPECT_GE(open, 0.999) << from_corner_m;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, SliceTechniques,
                         testing::Values("hbao", "gtao", "bitmask", "layered"),
                         [](const auto& tested) { return tested.param; });

using Slices = SliceTechniques;

TEST_F(Slices, ABitmaskLetsLightPassBehindAThinRailAndHorizonsDoNot) {
    Scene scene = tests::facing_wall(5.0F);
    tests::add_box(scene, {-3.0F, -0.03F, -4.6F}, {3.0F, 0.03F, -4.55F});
    double means[2] = {};
    int i = 0;
    for (const char* name : {"gtao", "bitmask"}) {
        Variant choice = choice_of(name);
        choice.samples = 64;
        choice.parameters = {{"radius_m", 1.0}};
        if (choice.technique == "bitmask") choice.parameters["thickness"] = 0.05;
        const std::vector<float> open = accessibility(scene, choice);
        for (const float value : open) means[i] += value / static_cast<double>(open.size());
        ++i;
    }
    EXPECT_GT(means[1], means[0] + 0.01);
}

TEST_F(Slices, TwoLayersFindABoxThatAPlateHides) {
    // Beside a plate far before the wall, the wall is seen; the box on the wall is not.
    Scene scene = tests::facing_wall(6.0F);
    tests::add_box(scene, {0.06F, -5.0F, -3.01F}, {5.0F, 5.0F, -3.0F});
    const auto mean_beside = [&](const std::string& name) {
        Variant choice = choice_of(name);
        choice.samples = 64;
        choice.parameters = {{"radius_m", 0.5}, {"cut_off", 1.0}};
        const std::vector<float> open = accessibility(scene, choice);
        double sum = 0.0;
        for (int y = 48; y < 80; ++y) {
            sum += open[static_cast<std::size_t>(y) * kSlicePixels + kSlicePixels / 2];
        }
        return sum / 32.0;
    };
    EXPECT_GE(mean_beside("layered"), 0.98) << "nothing is near";
    tests::add_box(scene, {0.2F, -5.0F, -6.0F}, {1.2F, 5.0F, -5.8F});
    EXPECT_GE(mean_beside("bitmask"), 0.98) << "one layer sees the plate only, too far away";
    EXPECT_LT(mean_beside("layered"), 0.95);
}

TEST_F(Slices, StepsDivideTheSamplesIntoSlices) {
    Variant choice = choice_of("bitmask");
    choice.samples = 12;
    EXPECT_FALSE(problems_of(choice).empty()) << "no whole number of slices of 2 x 4";
    choice.parameters["steps"] = 6.0;
    ASSERT_TRUE(problems_of(choice).empty());
    EXPECT_EQ(fan_of_slices(choice).count, 1);
    EXPECT_EQ(fetches_per_pixel(choice), 12 + 3);
}

TEST(TurnTile, SpreadsSixteenAnglesAndJittersEvenly) {
    const double sector_rad = std::numbers::pi / 3.0;
    std::vector<double> angles;
    std::vector<double> jitters;
    for (const Turn& turn : turn_tile(sector_rad)) {
        angles.push_back(std::atan2(turn.sine, turn.cosine) / sector_rad);
        jitters.push_back(turn.jitter);
    }
    std::sort(angles.begin(), angles.end());
    std::sort(jitters.begin(), jitters.end());
    ASSERT_EQ(angles.size(), 16U);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        EXPECT_NEAR(angles[i], (static_cast<double>(i) + 0.5) / 16.0, 1e-6);
        EXPECT_NEAR(jitters[i], (static_cast<double>(i) + 0.5) / 16.0, 1e-6);
    }
}

}  // namespace
}  // namespace obscura::renderer
