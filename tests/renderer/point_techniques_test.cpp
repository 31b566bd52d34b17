// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "renderer/gl/context.h"
#include "renderer/hard_cases/agreement.h"
#include "renderer/hard_cases/bench.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/hemisphere.h"
#include "renderer/technique/starcraft2.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

constexpr int kPointPixels = 128;
constexpr float kWall_m = 6.0F;
const double kHalfView_m = kWall_m * std::tan(std::numbers::pi / 6.0);

class PointTechniques : public testing::Test {
  protected:
    Frame render(const Scene& scene, const Variant& choice, int width = kPointPixels,
                 int height = kPointPixels) {
        const GpuScene gpu(scene);
        return renderer_.render({gpu, lighting_, tests::forward_camera()}, choice, width, height);
    }

    std::vector<float> open(const Scene& scene, const Variant& choice) {
        return render(scene, choice).read_floats(Target::kAccessibility);
    }

    /// Holds the wall beside the corner, by its distance from it, against a closed form.
    void expect_profile(const Variant& choice, double radius_m,
                        const std::function<double(double share)>& form) {
        const std::vector<float> values = open(corner(), choice);
        for (int column = 0; column + 4 <= kPointPixels; column += 4) {
            const double from_corner_m =
                (2.0 * (column + 2) / kPointPixels - 1.0) * kHalfView_m + 1.0;
            if (from_corner_m < 0.1 || from_corner_m > 2.0) continue;
            double mean = 0.0;
            for (int y = 48; y < 80; ++y) {
                for (int x = column; x < column + 4; ++x) {
                    mean += values[static_cast<std::size_t>(y * kPointPixels + x)] / (4.0 * 32.0);
                }
            }
            EXPECT_NEAR(mean, form(from_corner_m / radius_m), 0.015) << from_corner_m << " m";
        }
    }

    /// A wall that faces the camera, whose left end meets another that comes towards it.
    static Scene corner() {
        Scene scene = tests::empty_scene();
        tests::add_quad(scene, {-1.0F, -50.0F, -kWall_m}, {100.0F, 0.0F, 0.0F},
                        {0.0F, 100.0F, 0.0F});
        tests::add_quad(scene, {-1.0F, -50.0F, 50.0F}, {0.0F, 0.0F, -50.0F - kWall_m},
                        {0.0F, 100.0F, 0.0F});
        return scene;
    }

    static Scene cube_far_before_wall() {
        Scene scene = tests::facing_wall(8.0F);
        tests::add_box(scene, {-1.0F, -1.0F, -4.5F}, {1.0F, 1.0F, -3.5F});
        return scene;
    }

    HeadlessContext context_;
    Renderer renderer_;
    Lighting lighting_;
};

TEST_F(PointTechniques, HemisphereMeetsTheClosedFormOfACorner) {
    Variant choice = tests::choice_of("hemisphere");
    choice.samples = 128;
    choice.parameters = {{"radius_m", 1.5}, {"bias", 0.0}};
    // The share of a disc beyond a chord: directions with the cosine's density, all of one length.
    expect_profile(choice, 1.5, [](double c) {
        return c >= 1.0 ? 1.0
                        : 1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / std::numbers::pi;
    });
}

TEST_F(PointTechniques, Starcraft2MeetsTheClosedFormOfACorner) {
    Variant choice = tests::choice_of("starcraft2");
    choice.samples = 128;
    choice.parameters = {{"radius_m", 1.5},       {"epsilon", 0.0},      {"full_threshold", 100.0},
                         {"no_threshold", 100.0}, {"small_radius", 0.0}, {"footprint", 100.0},
                         {"distance_weight", 0.0}};
    // A component of an evenly spread direction is evenly spread (Archimedes), the lengths are from
    // a half to one.
    expect_profile(choice, 1.5, [](double c) {
        const double from = std::max(c, 0.5);
        return c >= 1.0 ? 1.0 : 1.0 - ((1.0 - from) + c * std::log(from));
    });
}

TEST_F(PointTechniques, HemisphereHasAHaloThatItsRangeCheckTakesAway) {
    Variant choice = tests::choice_of("hemisphere");
    choice.parameters = {{"radius_m", 0.5}, {"range_check", 0.0}};
    const auto darkest = [&] {
        const std::vector<float> values = open(cube_far_before_wall(), choice);
        return *std::min_element(values.begin(), values.end());
    };
    EXPECT_LT(darkest(), 0.8F);
    choice.parameters["range_check"] = 1.0;
    EXPECT_EQ(darkest(), 1.0F);
}

TEST_F(PointTechniques, Starcraft2LeavesAWallBehindAFarOccluderOpen) {
    Variant choice = tests::choice_of("starcraft2");
    choice.parameters["radius_m"] = 0.5;
    const std::vector<float> values = open(cube_far_before_wall(), choice);
    EXPECT_EQ(*std::min_element(values.begin(), values.end()), 1.0F);
}

TEST_F(PointTechniques, Starcraft2CoversNoMoreOfTheImageThanItsFootprint) {
    Variant capped = tests::choice_of("starcraft2");
    capped.parameters = {{"radius_m", 100.0}, {"footprint", 0.1}};
    Variant small = capped;
    small.parameters = {{"radius_m", 0.1 * 2.0 * kHalfView_m}, {"footprint", 100.0}};
    const Frame frame = render(corner(), capped);
    const std::vector<float> depth = frame.read_floats(Target::kDepth);
    const std::vector<float> a = frame.read_floats(Target::kAccessibility);
    const std::vector<float> b = open(corner(), small);
    double apart = 0.0;
    double dark = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(depth[i] - kWall_m) > 1e-4F) continue;
        apart += std::abs(a[i] - b[i]) / static_cast<double>(a.size());
        dark = std::max(dark, 1.0 - static_cast<double>(a[i]));
    }
    EXPECT_LT(apart, 1e-4);
    EXPECT_GT(dark, 0.2) << "nothing was occluded";
}

TEST_F(PointTechniques, Starcraft2IsAsDefinedInEveryOneOfItsOptions) {
    Scene scene = tests::facing_wall(5.0F);
    tests::add_box(scene, {-0.6F, -0.8F, -5.0F}, {0.4F, 0.3F, -4.4F});
    const std::map<std::string, double> ways[] = {{{"depth_halvings", 1.0}},
                                                  {{"depth_halvings", 2.0}},
                                                  {{"small_radius", 0.0}},
                                                  {{"small_radius", 0.6}, {"small_power", 3.0}},
                                                  {{"distance_weight", -2.0}},
                                                  {{"no_threshold", 0.1}},
                                                  {{"power", 0.01}}};
    for (const auto& way : ways) {
        Variant choice = tests::choice_of("starcraft2");
        choice.parameters = way;
        const Frame frame = render(scene, choice, 61, 35);
        const SeenBuffers buffers = seen_buffers(frame, tests::forward_camera());
        const Agreement found =
            agreement_of(admitted_by(starcraft2_model(buffers, choice), buffers),
                         frame.read_floats(Target::kAccessibility), 61, way.begin()->first);
        EXPECT_EQ(found.off, 0U) << found.worst.where << ": defined " << found.worst.definition
                                 << ", measured " << found.worst.measured;
        EXPECT_LT(found.uncertain, found.pixels / 20) << way.begin()->first;
        const PlannedTarget* small = frame.plan().find("small depth");
        const int halvings = starcraft2_halvings(choice);
        ASSERT_EQ(small != nullptr, halvings > 0);
        if (small != nullptr) {
            EXPECT_EQ(small->width, halvings == 1 ? 31 : 16);
        }
    }
}

TEST_F(PointTechniques, TheWeightsOfEachOfStarcraft2sSetsAddUpToOne) {
    for (const int samples : {1, 3, 4, 17, 128}) {
        Variant choice = tests::choice_of("starcraft2");
        choice.samples = samples;
        const Starcraft2Points points = starcraft2_points(choice);
        EXPECT_EQ(points.wide.size() + points.small.size(), static_cast<std::size_t>(samples));
        EXPECT_EQ(points.small.size(), static_cast<std::size_t>(samples >= 4 ? samples / 4 : 0));
        for (const auto* set : {&points.wide, &points.small}) {
            double sum = 0.0;
            for (const WeightedPoint& point : *set) sum += point.weight;
            if (!set->empty()) {
                EXPECT_NEAR(sum, 1.0, 1e-12);
            }
        }
    }
}

TEST_F(PointTechniques, UnsharpIsWhatLuftDefinesAndDarkensBehindEdgesOnly) {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -40.0F});
    tests::add_box(scene, {-1.0F, -1.0F, -5.0F}, {1.0F, 1.0F, -4.0F});
    Variant choice = tests::choice_of("unsharp");
    const double strength = 20.0;
    choice.parameters = {{"strength", strength}, {"radius", 0.1}};
    const Frame frame = render(scene, choice, 96, 64);
    const std::vector<float> before = frame.read_components(Target::kHdr, 3);
    const std::vector<float> after = frame.read_components(Target::kColour, 3);
    const std::vector<float> depth_m = frame.read_floats(Target::kDepth);
    const double far_m = tests::forward_camera().far_m;
    const auto depth = [&](int x, int y) {
        return std::min(static_cast<double>(depth_m[static_cast<std::size_t>(
                            std::clamp(y, 0, 63) * 96 + std::clamp(x, 0, 95))]) /
                            far_m,
                        1.0);
    };
    const double step_px = 0.1 * 64.0 / 8.0;
    int darkened = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 96; ++x) {
            double sum = 0.0;
            double weights = 0.0;
            for (int j = -8; j <= 8; ++j) {
                for (int i = -8; i <= 8; ++i) {
                    const double weight = std::exp(-2.0 * (i * i + j * j) / 64.0);
                    // Rows are read from above, and taps count from below.
                    sum += weight * depth(x + static_cast<int>(std::floor(i * step_px + 0.5)),
                                          y - static_cast<int>(std::floor(j * step_px + 0.5)));
                    weights += weight;
                }
            }
            const auto at = static_cast<std::size_t>(y * 96 + x);
            const double behind =
                depth_m[at] < kBackgroundLimit_m ? std::max(depth(x, y) - sum / weights, 0.0) : 0.0;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const double was = static_cast<double>(before[3 * at + channel]);
                const double is = static_cast<double>(after[3 * at + channel]);
                ASSERT_NEAR(is, std::max(was - strength * behind, 0.0), 1e-3 + 1e-3 * was)
                    << x << ", " << y;
                ASSERT_LE(is, was);
                darkened += is < was - 0.02 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(darkened, 30);
}

TEST_F(PointTechniques, UnsharpLeavesAWallThatFacesTheCameraAlone) {
    const Frame frame = render(tests::facing_wall(5.0F), tests::choice_of("unsharp"), 32, 24);
    EXPECT_EQ(frame.read_components(Target::kHdr, 3), frame.read_components(Target::kColour, 3));
}

}  // namespace
}  // namespace obscura::renderer
