// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/progressive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/gl/context.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using testing::HasSubstr;
using tests::choice_of;

constexpr int kSpreadWidth = 75;
constexpr int kSpreadHeight = 51;

/// Boxes on a floor before a wall.
Scene corner_with_boxes() {
    Scene scene = tests::facing_wall(6.0F);
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -40.0F});
    tests::add_box(scene, {-1.5F, -1.0F, -5.5F}, {-0.3F, 0.2F, -4.4F});
    tests::add_box(scene, {0.2F, -1.0F, -4.0F}, {0.9F, -0.3F, -3.4F});
    return scene;
}

Variant over_frames(const std::string& technique, const std::string& frames) {
    Variant choice = choice_of(technique);
    choice.frames = frames;
    return choice;
}

/// The technique in the second of two frames only.
template <int kFrame>
Technique one_frame_of(const std::string& name) {
    Technique technique = *find_technique(name);
    technique.recipe = [](const Variant& variant) {
        Variant part = variant;
        part.frames = "2";
        part.frame = kFrame;
        return find_technique(variant.technique)->recipe(part);
    };
    return technique;
}

class Progressive : public testing::Test {
  protected:
    std::vector<float> render(const Technique& technique, const Variant& choice) {
        const Scene scene = corner_with_boxes();
        const GpuScene gpu(scene);
        const Lighting lighting;
        const FramePlan plan =
            plan_frame(needs_of(scene, lighting), technique, choice, kSpreadWidth, kSpreadHeight);
        const Frame frame = renderer_.draw({gpu, lighting, tests::forward_camera()}, plan);
        EXPECT_TRUE(renderer_.mismatches().empty()) << *renderer_.mismatches().begin();
        return frame.read_accessibility();
    }
    std::vector<float> render(const Variant& choice) {
        return render(*find_technique(choice.technique), choice);
    }

    HeadlessContext context_;
    Renderer renderer_;
};

double most_apart(const std::vector<float>& a, const std::vector<float>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::abs(static_cast<double>(a[i] - b[i])));
    }
    return most;
}

TEST(ProgressiveKernel, EverySampleIsInOneFrameOnly) {
    std::vector<int> kernel(48);
    std::iota(kernel.begin(), kernel.end(), 0);
    for (const int group : {1, 4, 8}) {
        for (const std::string frames : {"1", "2", "3", "6"}) {
            std::vector<int> all;
            Variant variant = over_frames("blizzard", frames);
            for (variant.frame = 0; variant.frame < frames_of(variant); ++variant.frame) {
                const std::vector<int> part = part_of(kernel, variant, group);
                EXPECT_EQ(part.size(), kernel.size() / static_cast<std::size_t>(std::stoi(frames)));
                all.insert(all.end(), part.begin(), part.end());
            }
            std::sort(all.begin(), all.end());
            EXPECT_EQ(all, kernel) << frames << " frames, groups of " << group;
        }
    }
}

TEST_F(Progressive, AMeanOverSamplesIsTheSameHoweverManyFramesShareThem) {
    for (const std::string technique : {"blizzard", "raymarch", "hemisphere"}) {
        Variant whole = choice_of(technique);
        whole.samples = 24;
        const std::vector<float> wanted = render(whole);
        EXPECT_LT(*std::min_element(wanted.begin(), wanted.end()), 0.8F) << technique;
        for (const std::string frames : {"2", "3", "4", "8"}) {
            Variant spread = whole;
            spread.frames = frames;
            EXPECT_LT(most_apart(render(spread), wanted), 2.0e-6) << technique << ", " << frames;
        }
    }
}

TEST_F(Progressive, WhatIsShownIsTheMeanOfTheFramesParts) {
    for (const std::string technique : {"crytek", "blizzard", "starcraft2", "hemisphere", "hbao",
                                        "alchemy", "homebrewed", "gtao", "bitmask", "layered"}) {
        Variant choice = choice_of(technique);
        choice.samples = 32;
        const std::vector<float> first = render(one_frame_of<0>(technique), choice);
        const std::vector<float> second = render(one_frame_of<1>(technique), choice);
        std::vector<float> mean(first.size());
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5F * (first[i] + second[i]);
        EXPECT_GT(most_apart(first, second), 0.01) << technique << ": both took the same samples";
        choice.frames = "2";
        EXPECT_LT(most_apart(render(choice), mean), 1.0e-6) << technique;
    }
}

TEST(ProgressiveVariant, IsRefusedWhereAFrameCannotHaveItsShare) {
    const auto message = [](const std::string& technique, const std::string& frames) {
        const auto problems = problems_of(over_frames(technique, frames));
        return problems.size() == 1 ? problems[0].key + ": " + problems[0].message : "";
    };
    EXPECT_EQ(message("gtao", "2"), "");
    EXPECT_THAT(message("gtao", "4"), HasSubstr("frames: 4 is not allowed with 16 samples"));
    EXPECT_THAT(message("gtao", "4"), HasSubstr("multiples of 8"));
    EXPECT_THAT(message("crytek", "2"), HasSubstr("crytek takes multiples of 8"));
    EXPECT_THAT(message("blizzard", "5"), HasSubstr("\"5\" is unknown; allowed are 1, 2, 3"));
    EXPECT_THAT(message("raytraced", "2"), HasSubstr("traces all rays of a pixel at once"));
    EXPECT_THAT(message("unsharp", "2"), HasSubstr("no kernel that frames could share"));
    EXPECT_THAT(message("none", "2"), HasSubstr("no kernel that frames could share"));
    EXPECT_THAT(message("reference", "2"), HasSubstr("no kernel that frames could share"));
}

TEST(ProgressiveVariant, ReadsEachSampleOnceAndItsPixelInEveryFrame) {
    const int whole = fetches_per_pixel(choice_of("blizzard"));
    // Depth, normal and rotation again, and the mean before.
    EXPECT_EQ(fetches_per_pixel(over_frames("blizzard", "2")), whole + 4);
    EXPECT_EQ(fetches_per_pixel(over_frames("blizzard", "3")), whole + 8);
}

}  // namespace
}  // namespace obscura::renderer
