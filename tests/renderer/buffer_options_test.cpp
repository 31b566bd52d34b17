// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/noise.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using tests::choice_of;
using tests::forward_camera;

class BufferOptions : public testing::Test {
  protected:
    Frame render(const Scene& scene, const Variant& choice, int width, int height,
                 int supersampling = 1) {
        const Lighting lighting;
        const GpuScene gpu(scene);
        FrameOptions options;
        options.supersampling = supersampling;
        return renderer_.render({gpu, lighting, forward_camera(), options}, choice, width, height);
    }

    HeadlessContext context_;
    Renderer renderer_;
};

/// A floor that leans away, and a plate before it over the right half.
Scene plate_over_floor() {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-400.0F, -1.0F, 0.0F}, {800.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -400.0F});
    tests::add_quad(scene, {0.013F, -9.0F, -1.0F}, {9.0F, 0.0F, 0.0F}, {0.0F, 18.0F, 0.0F});
    return scene;
}

TEST_F(BufferOptions, ATiltedPlaneStaysOpenAtEveryScaleAndSize) {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-400.0F, -1.0F, 0.0F}, {800.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -400.0F});
    for (const std::string& scale : find_option("ao_scale")->allowed) {
        for (const auto& [width, height] : {std::pair(96, 64), {97, 63}, {33, 35}}) {
            Variant choice = choice_of("gtao", "separable");
            choice.ao_scale = scale;
            const Frame frame = render(scene, choice, width, height);
            const std::vector<float> open = frame.read_accessibility();
            ASSERT_EQ(open.size(), static_cast<std::size_t>(width * height));
            EXPECT_GE(*std::min_element(open.begin(), open.end()), 0.999F)
                << scale << ", " << width << 'x' << height;
        }
    }
}

TEST_F(BufferOptions, AtALowerScaleTheBuffersAreThatMuchSmallerAndSoIsTheWork) {
    Variant choice = choice_of("gtao", "separable");
    choice.ao_scale = "0.5";
    const Frame frame = render(plate_over_floor(), choice, 97, 63);
    const PlannedTarget* small = frame.plan().find(Target::kAccessibility);
    ASSERT_NE(small, nullptr);
    EXPECT_EQ(small->width, 49);
    EXPECT_EQ(small->height, 32);
    EXPECT_EQ(frame.plan().find(frame.plan().final_accessibility())->width, 97);
    EXPECT_TRUE(frame.plan().has(Phase::kSeen));
    EXPECT_TRUE(frame.plan().has(Phase::kUpsample));
}

TEST_F(BufferOptions, WhatIsBroughtUpDoesNotLeakAcrossAnEdge) {
    // The floor is dark near the plate's foot only in a technique that sees it; here the plate is
    // far from it, and both are open. What leaks would show on either side.
    for (const std::string scale : {"0.5", "0.25"}) {
        Variant choice = choice_of("gtao");
        choice.ao_scale = scale;
        choice.parameters = {{"radius_m", 0.2}};
        const std::vector<float> open =
            render(plate_over_floor(), choice, 97, 63).read_accessibility();
        EXPECT_GE(*std::min_element(open.begin(), open.end()), 0.97F) << scale;
    }
}

TEST_F(BufferOptions, EmptyPixelsStayExactlyOpenAtEveryScale) {
    Scene scene = tests::empty_scene();
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 1.0F, -4.0F});
    for (const std::string scale : {"0.5", "0.25"}) {
        Variant choice = choice_of("crytek", "separable");
        choice.ao_scale = scale;
        const Frame frame = render(scene, choice, 75, 51);
        const std::vector<float> depth_m = frame.read_floats(Target::kDepth);
        const std::vector<float> open = frame.read_accessibility();
        for (std::size_t i = 0; i < depth_m.size(); ++i) {
            if (depth_m[i] >= kBackgroundLimit_m) {
                ASSERT_EQ(open[i], 1.0F) << i;
            }
        }
    }
}

TEST_F(BufferOptions, HalfSizeTakesTheSameRaysAsTheFullOne) {
    // Every second pixel of the full buffer is a pixel of the small one, depth and all.
    Variant choice = choice_of("gtao");
    const Frame full = render(plate_over_floor(), choice, 97, 63);
    choice.ao_scale = "0.5";
    const Frame half = render(plate_over_floor(), choice, 97, 63);
    const std::vector<float> all_m = full.read_floats(Target::kDepth);
    const std::vector<float> some_m = half.read_floats(Target::kSeenDepth);
    ASSERT_EQ(some_m.size(), 49U * 32U);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 49; ++x) {
            // Upper row first: both begin with the lowest row's first pixel at the bottom.
            const std::size_t there = static_cast<std::size_t>(62 - 2 * (31 - y)) * 97 + 2 * x;
            ASSERT_EQ(some_m[static_cast<std::size_t>(y) * 49 + x], all_m[there]) << x << ' ' << y;
        }
    }
}

TEST_F(BufferOptions, EveryOptionMakesAnImageWithSeveralSamplesAPixelToo) {
    for (const VariantOption& option : variant_options()) {
        for (const std::string& word : option.allowed) {
            Variant choice = choice_of("layered", "separable");
            choice.*option.value = word;
            if (!problems_of(choice).empty()) continue;  // of 16 samples in slices of 8
            const Frame frame = render(plate_over_floor(), choice, 41, 23, 2);
            const std::vector<float> open = frame.read_accessibility();
            ASSERT_EQ(open.size(), 41U * 23U) << option.name << ' ' << word;
            for (const float value : open) {
                ASSERT_TRUE(value >= 0.0F && value <= 1.0F) << option.name << ' ' << word;
            }
            EXPECT_EQ(frame.read_display().size(), 3U * 41U * 23U);
        }
    }
    EXPECT_TRUE(renderer_.mismatches().empty()) << *renderer_.mismatches().begin();
}

TEST_F(BufferOptions, NormalsInFewerBitsOrFromDepthPointTheSameWay) {
    const Frame exact = render(plate_over_floor(), choice_of("gtao"), 64, 48);
    const std::vector<float> wanted = exact.read_accessibility();
    for (const std::string format : {"rg8", "oct16", "from-depth"}) {
        Variant choice = choice_of("gtao");
        choice.normal_format = format;
        const std::vector<float> found =
            render(plate_over_floor(), choice, 64, 48).read_accessibility();
        double sum = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i) sum += std::abs(found[i] - wanted[i]);
        EXPECT_LT(sum / static_cast<double>(found.size()), 0.01) << format;
    }
}

TEST(NoiseTiles, TakeEveryNumberOnce) {
    for (const char* kind : {"blue64", "hilbert64"}) {
        const Tile<glm::dvec2>& tile = noise_tile(kind);
        ASSERT_EQ(tile.values.size(), 4096U);
        std::set<double> numbers;
        for (const glm::dvec2& value : tile) {
            ASSERT_TRUE(value.x > 0.0 && value.x < 1.0 && value.y >= 0.0 && value.y < 1.0);
            numbers.insert(value.x);
        }
        EXPECT_EQ(numbers.size(), 4096U) << kind;
    }
}

TEST(NoiseTiles, BlueOnesKeepNeighboursApart) {
    const Tile<glm::dvec2>& tile = noise_tile("blue64");
    double apart = 0.0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            apart += std::abs(tile.at(x, y).x - tile.at(x + 1, y).x) / 4096.0;
        }
    }
    EXPECT_GT(apart, 0.37) << "independent numbers are a third apart";
}

TEST(NoiseTiles, AlongAHilbertCurveBlocksHoldEvenlySpreadNumbers) {
    const Tile<glm::dvec2>& tile = noise_tile("hilbert64");
    for (int block = 0; block < 64; ++block) {
        std::vector<double> numbers;
        for (int i = 0; i < 64; ++i) {
            numbers.push_back(tile.at(8 * (block % 8) + i % 8, 8 * (block / 8) + i / 8).x);
        }
        std::sort(numbers.begin(), numbers.end());
        double gap = numbers.front() + 1.0 - numbers.back();
        for (std::size_t i = 1; i < 64; ++i) gap = std::max(gap, numbers[i] - numbers[i - 1]);
        ASSERT_LT(gap, 0.05) << "random ones leave 0.074 on a circle of 1; block " << block;
    }
}

TEST(VariantOptions, AreRefusedWhereATechniqueDoesNotHaveThem) {
    for (const auto& [technique, option, word] : {std::tuple("none", &Variant::ao_scale, "0.5"),
                                                  {"unsharp", &Variant::ao_format, "r8"},
                                                  {"raytraced", &Variant::noise, "blue64"},
                                                  {"raytraced", &Variant::depth_format, "r16f"}}) {
        Variant variant = standard_variant(*find_technique(technique));
        variant.*option = word;
        EXPECT_EQ(problems_of(variant).size(), 1U) << technique;
    }
}

}  // namespace
}  // namespace obscura::renderer
