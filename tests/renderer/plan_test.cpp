// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/denoise/denoise.h"
#include "renderer/frame/plan.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using tests::choice_of;

SceneNeeds high_needs() {
    SceneNeeds needs;
    needs.environment = true;
    needs.irradiance_grid = true;
    needs.lights = 1;
    needs.tone_mapping = true;
    needs.normal_mapping = true;
    needs.textures = true;
    needs.specular = true;
    needs.roughness = true;
    needs.shadow_size = 2048;
    return needs;
}

/// A scene that has everything.
SceneNeeds all_needs() {
    SceneNeeds needs = high_needs();
    needs.point_lights = 2;
    needs.point_shadow_size = 512;
    needs.cut_out = true;
    needs.blended = true;
    needs.emission = true;
    return needs;
}

FrameOptions all_options() { return {2, 0.9F, true}; }

TEST(Plan, ConstantLightUnderCrytekAllocatesNeitherNormalNorLight) {
    const FramePlan plan = plan_frame({}, choice_of("crytek", "separable"), 1280, 720);
    EXPECT_EQ(plan.find(Target::kNormal), nullptr);
    EXPECT_EQ(plan.find(Target::kAmbient), nullptr);
    EXPECT_EQ(plan.find(Target::kDirect), nullptr);
    EXPECT_EQ(plan.find(Target::kShadow), nullptr);
    EXPECT_EQ(plan.find(Target::kHdr), nullptr);
    EXPECT_FALSE(plan.has(Phase::kLight));
    EXPECT_NE(plan.find(Target::kDepth), nullptr);
}

TEST(Plan, ConstantLightUnderBlizzardAddsTheNormalAndNoLight) {
    const FramePlan plan = plan_frame({}, choice_of("blizzard"), 1280, 720);
    EXPECT_NE(plan.find(Target::kNormal), nullptr);
    EXPECT_FALSE(plan.has(Phase::kLight));
}

TEST(Plan, NoneUnderConstantLightIsGeometryAndComposite) {
    const FramePlan plan = plan_frame({}, choice_of("none"), 1280, 720);
    ASSERT_EQ(plan.passes.size(), 2U);
    EXPECT_TRUE(plan.has(Phase::kGeometry));
    EXPECT_TRUE(plan.has(Phase::kComposite));
    EXPECT_EQ(plan.find(Target::kDepth), nullptr);
}

TEST(Plan, EverythingOnHasEveryPassAndLeavesNothingOut) {
    const FramePlan plan =
        plan_frame(all_needs(), choice_of("blizzard", "separable"), 640, 360, all_options());
    EXPECT_EQ(plan.passes.size(), 12U);  // the filter has two steps
    EXPECT_TRUE(plan.left_out.empty());
    EXPECT_EQ(plan.final_accessibility(), "denoised");
    EXPECT_EQ(plan.find(Target::kPointShadow)->layers, 12);
    EXPECT_EQ(plan.find(Target::kHdr)->width, 1280);
    EXPECT_EQ(plan.find(Target::kResolved)->width, 640);
}

TEST(Plan, WhatASceneHasNotIsLeftOutWithAReason) {
    const FramePlan plan = plan_frame({}, choice_of("none"), 64, 64);
    for (const char* what :
         {"normal", "depth", "emission", "shadow", "point shadow", "occluders", "accessibility",
          "denoise", "light", "sky", "blend", "tone map", "resolve", "cut-out test",
          "normal mapping", "albedo texture fetch", "roughness texture fetch"}) {
        const auto found =
            std::find_if(plan.left_out.begin(), plan.left_out.end(),
                         [what](const LeftOut& left_out) { return left_out.what == what; });
        ASSERT_NE(found, plan.left_out.end()) << what;
        EXPECT_FALSE(found->why.empty()) << what;
    }
}

TEST(Plan, EveryTargetThatIsReadIsWrittenBefore) {
    for (const Technique& technique : techniques()) {
        for (const Denoise& denoise : denoise_filters()) {
            if (!technique.makes_accessibility() && !denoise.recipe.steps.empty()) continue;
            for (const auto& [needs, options] :
                 {std::pair(SceneNeeds{}, FrameOptions{}), std::pair(high_needs(), FrameOptions{}),
                  std::pair(all_needs(), all_options())}) {
                const FramePlan plan =
                    plan_frame(needs, choice_of(technique.name, denoise.name), 64, 64, options);
                std::vector<std::string> written;
                for (const PlannedPass& pass : plan.passes) {
                    for (const auto& [target, sampler] : pass.reads) {
                        EXPECT_NE(std::find(written.begin(), written.end(), target), written.end())
                            << technique.name << ": " << pass.name << " reads " << target;
                    }
                    written.insert(written.end(), pass.writes.begin(), pass.writes.end());
                }
                for (const PlannedTarget& target : plan.targets) {
                    EXPECT_NE(std::find(written.begin(), written.end(), target.name), written.end())
                        << target.name << " is allocated and never written";
                }
            }
        }
    }
}

TEST(Plan, BytesAreThoseOfTheFormats) {
    const FramePlan plan = plan_frame(high_needs(), choice_of("none"), 100, 10);
    EXPECT_EQ(plan.find(Target::kHdr)->bytes, 8000U);
    EXPECT_EQ(plan.find(Target::kAlbedo)->bytes, 4000U);
    EXPECT_EQ(plan.find(Target::kShadow)->bytes, 2048U * 2048U * 4U);
}

TEST(Plan, BadChoicesAndSizesAreRefused) {
    EXPECT_THROW((void)plan_frame({}, choice_of("none"), 0, 10), base::Error);
    EXPECT_THROW((void)plan_frame({}, choice_of("none"), 10, 20000), base::Error);
    EXPECT_THROW((void)plan_frame({}, choice_of("none"), 10, 10, {.supersampling = 0}),
                 base::Error);
    EXPECT_THROW((void)plan_frame({}, choice_of("none"), 16000, 10, {.supersampling = 2}),
                 base::Error);
    EXPECT_THROW((void)plan_frame({}, choice_of("none"), 10, 10, {.occluding_opacity = 0.0F}),
                 base::Error);
    Variant odd = choice_of("crytek");
    odd.samples = 12;
    EXPECT_THROW((void)plan_frame({}, odd, 10, 10), base::Error);
    odd.samples = -8;
    EXPECT_THROW((void)plan_frame({}, odd, 10, 10), base::Error);
    EXPECT_THROW((void)plan_frame({}, choice_of("blizzard", "sharpen"), 10, 10), base::Error);
}

TEST(Choice, ProblemsNameTheKeyTheValueAndWhatIsAllowed) {
    Variant choice = choice_of("blizzard");
    choice.samples = -1;
    choice.parameters = {{"radius_m", std::nan("")}, {"offset_scale", 0.1}};
    const auto problems = problems_of(choice);
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_EQ(problems[0].key, "samples");
    EXPECT_NE(problems[0].message.find("-1"), std::string::npos);
    EXPECT_EQ(problems[1].key, "offset_scale");
    EXPECT_EQ(problems[2].key, "radius_m");
    choice.technique = "hbao9";
    ASSERT_EQ(problems_of(choice).size(), 1U);
    EXPECT_NE(problems_of(choice)[0].message.find("crytek"), std::string::npos);
}

TEST(Choice, VariantsAreNamedAsInTheThesis) {
    EXPECT_EQ(choice_of("blizzard").variant_name(), "Blizzard24");
    EXPECT_EQ(choice_of("raymarch").variant_name(), "RayMarching30");
    EXPECT_EQ(choice_of("none").variant_name(), "None");
}

}  // namespace
}  // namespace obscura::renderer
