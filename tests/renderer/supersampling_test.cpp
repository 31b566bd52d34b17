// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/reference.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using tests::choice_of;

constexpr int kSampledWidth = 96;
constexpr int kSampledHeight = 64;

class Supersampling : public testing::Test {
  protected:
    Frame render(const Scene& scene, const Variant& choice, const FrameOptions& options,
                 const TracedAccessibility& traced = {}) {
        const GpuScene gpu(scene);
        const ReferenceScene rays(scene);
        return renderer_.render({gpu,
                                 {},
                                 tests::forward_camera(),
                                 options,
                                 traced,
                                 [&rays]() -> const ReferenceScene& { return rays; }},
                                choice, kSampledWidth, kSampledHeight);
    }

    HeadlessContext context_;
    Renderer renderer_;
};

TEST_F(Supersampling, LeavesTheAccessibilityAsItIsWithOneSampleAPixel) {
    const Scene scene = tests::scene_of_all_kinds();
    for (const std::optional<float> occluding :
         {std::optional<float>(), std::optional<float>(0.9F)}) {
        for (const Technique& technique : techniques()) {
            if (technique.recipe == nullptr || !technique.makes_accessibility()) continue;
            const Variant choice = choice_of(technique.name, "separable");
            const Frame once = render(scene, choice, {.occluding_opacity = occluding});
            for (const int samples : {2, 3, 4}) {
                const Frame often = render(
                    scene, choice, {.supersampling = samples, .occluding_opacity = occluding});
                EXPECT_EQ(once.read_bytes(once.plan().final_accessibility()),
                          often.read_bytes(often.plan().final_accessibility()))
                    << technique.name << ", " << samples << " samples a side";
            }
        }
    }
}

TEST_F(Supersampling, LetsNoAccessibilityLeakOverASilhouette) {
    // A slanted edge at 2 m before a wall at 10 m. The pixels that see the edge's left are a
    // quarter open, the others three quarters.
    Scene scene = tests::facing_wall(10.0F);
    tests::add_quad(scene, {-8.0F, -4.0F, -2.0F}, {8.3F, 0.0F, 0.0F}, {-0.5F, 8.0F, 0.0F});
    const Variant choice = choice_of("reference", "none");
    for (const int samples : {2, 3, 4}) {
        const Frame depth = render(scene, choice_of("crytek", "none"), {});
        const std::vector<float> depth_m = depth.read_floats(Target::kDepth);
        const auto traced = [&](const Camera&, int, int, const Variant&) {
            std::vector<float> open;
            for (const float z : depth_m) open.push_back(z < 5.0F ? 0.25F : 0.75F);
            return open;
        };
        const Frame frame = render(scene, choice, {.supersampling = samples}, traced);
        const std::vector<float> sample_depth_m = frame.read_floats(Target::kDepth);
        const std::vector<float> shown = frame.read_components(Target::kDisplay, 1);
        ASSERT_EQ(shown.size(), sample_depth_m.size());
        int near = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const bool is_near = sample_depth_m[i] < 5.0F;
            near += is_near ? 1 : 0;
            // sRGB code values of 0.25 and 0.75, of 255.
            ASSERT_NEAR(shown[i] * 255.0F, is_near ? 137.0F : 225.0F, 0.6F)
                << samples << " samples a side, sample " << i;
        }
        EXPECT_GT(near, 1000 * samples);
    }
}

TEST_F(Supersampling, GivesWhatNoPixelsMiddleSeesTheAccessibilityOfASurfaceBesideIt) {
    // Bars thinner than a pixel before the sky, beside a wall: samples of a bar lie in pixels whose
    // middle sees the sky, some of them next to pixels that see something.
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-8.0F, -4.0F, -4.0F}, {8.02F, 0.0F, 0.0F}, {0.4F, 8.0F, 0.0F});
    for (int i = 0; i < 40; ++i) {
        const float x = -0.3F + 0.043F * static_cast<float>(i);
        tests::add_quad(scene, {x, -4.0F, -3.0F}, {0.012F, 0.0F, 0.0F}, {0.3F, 8.0F, 0.0F});
    }
    const std::vector<float> depth_m =
        render(scene, choice_of("crytek"), {}).read_floats(Target::kDepth);
    const auto traced = [&](const Camera&, int, int, const Variant&) {
        return std::vector<float>(depth_m.size(), 0.25F);
    };
    const Frame frame = render(scene, choice_of("reference"), {.supersampling = 2}, traced);
    const std::vector<float> sample_depth_m = frame.read_floats(Target::kDepth);
    const std::vector<float> shown = frame.read_components(Target::kDisplay, 1);
    const auto empty = [&](int x, int y) {
        return depth_m[static_cast<std::size_t>(y) * kSampledWidth + x] >= kBackgroundLimit_m;
    };
    int beside = 0;
    for (int y = 2; y < 2 * kSampledHeight - 2; ++y) {
        for (int x = 2; x < 2 * kSampledWidth - 2; ++x) {
            const auto i = static_cast<std::size_t>(y) * 2 * kSampledWidth + x;
            if (sample_depth_m[i] >= kBackgroundLimit_m) continue;
            const int aside = x / 2 + (x % 2 == 0 ? -1 : 1);
            const int above = y / 2 + (y % 2 == 0 ? -1 : 1);
            if (empty(x / 2, y / 2) && empty(aside, y / 2) && empty(x / 2, above) &&
                empty(aside, above)) {
                continue;
            }
            beside += empty(x / 2, y / 2) ? 1 : 0;
            ASSERT_NEAR(shown[i] * 255.0F, 137.0F, 0.6F) << x << ' ' << y;
        }
    }
    EXPECT_GT(beside, 50) << "the test saw too little";
}

TEST_F(Supersampling, MakesDepthAndAlbedoOnlyWhereTheTechniqueReadsNoMore) {
    const FramePlan plan = plan_frame({}, choice_of("crytek", "separable"), kSampledWidth,
                                      kSampledHeight, {.supersampling = 2});
    EXPECT_EQ(plan.find(Target::kNormal), nullptr);
    EXPECT_EQ(plan.find(Target::kOccluderNormal), nullptr);
    EXPECT_EQ(plan.find(Target::kAmbient), nullptr);
    EXPECT_EQ(plan.find(Target::kDepth)->width, 2 * kSampledWidth);
    EXPECT_EQ(plan.find(Target::kOccluderDepth)->width, kSampledWidth);
    EXPECT_EQ(plan.find(Target::kAccessibility)->width, kSampledWidth);
    EXPECT_EQ(plan_frame({}, choice_of("none", "none"), kSampledWidth, kSampledHeight,
                         {.supersampling = 2})
                  .find(Target::kDepth),
              nullptr);
}

}  // namespace
}  // namespace obscura::renderer
