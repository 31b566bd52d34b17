// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "app/measure/measured_scene.h"
#include "renderer/gl/context.h"
#include "stimuli/stimulus.h"
#include "tests/support/test_scenes.h"

namespace obscura::app {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 36;

/// Boxes, a hedge with holes and a nearly opaque pane.
stimuli::BuiltinScene scene_with_pane() {
    return {.id = "pane",
            .title = "pane",
            .stands_in_for = "",
            .levels = {stimuli::Validity::kModerate},
            .cameras = {"forward"},
            .build =
                [] {
                    renderer::Scene scene = tests::scene_of_all_kinds();
                    scene.cameras = {tests::forward_camera()};
                    return scene;
                },
            .lighting =
                [](stimuli::Validity) {
                    renderer::Lighting lighting;
                    lighting.environment =
                        std::make_shared<renderer::Environment>(renderer::make_sky({}, 32));
                    lighting.irradiance_probes = true;
                    return lighting;
                }};
}

/// A study that asks for all that an image may be asked for beside its technique.
stimuli::Study demanding_study() {
    stimuli::Study study;
    study.name = "demanding";
    study.width = kWidth;
    study.height = kHeight;
    study.supersampling = 2;
    study.occluding_opacity = 0.9F;
    study.scenes = {{"pane", "pane", "forward", stimuli::Validity::kModerate}};
    for (const char* technique : {"crytek", "blizzard"}) {
        stimuli::Condition condition;
        condition.id = technique;
        condition.scene = "pane";
        condition.a = tests::choice_of(technique, "separable");
        condition.b = condition.a;
        condition.b.depth_format = "r16f";
        study.conditions.push_back(condition);
    }
    return study;
}

class ShownFrame : public testing::Test {
  protected:
    renderer::HeadlessContext context_;
    std::vector<stimuli::BuiltinScene> catalogue_{scene_with_pane()};
    stimuli::Study study_ = demanding_study();
    MeasureRequest request_;
};

TEST_F(ShownFrame, IsTheMeasuredFrameToTheByte) {
    MeasuredScene stage(request_);
    const MeasuredView view = views_of(request_, study_, catalogue_).at(0);
    stimuli::StimulusRenderer renderer(study_, catalogue_);
    for (const stimuli::Stimulus& stimulus : stimuli::stimuli_of(study_)) {
        const renderer::Frame shown = renderer.render(stimulus);
        const renderer::Frame measured = stage.render(view, stimulus.choice(), kWidth, kHeight);
        EXPECT_TRUE(shown.read_display() == measured.read_display()) << stimulus.file();
        ASSERT_EQ(shown.plan().targets.size(), measured.plan().targets.size());
        for (const renderer::PlannedTarget& planned : shown.plan().targets) {
            EXPECT_TRUE(shown.read_bytes(planned) == measured.read_bytes(planned))
                << stimulus.file() << ": " << planned.name;
        }
    }
}

TEST_F(ShownFrame, IsAnotherOneWithoutWhatTheStudyAsksFor) {
    MeasuredScene stage(request_);
    MeasuredView view = views_of(request_, study_, catalogue_).at(0);
    const renderer::Variant& half = study_.conditions.back().b;
    renderer::Variant full = half;
    full.depth_format = "r32f";
    const auto open = stage.render(view, half, kWidth, kHeight).read_accessibility();
    EXPECT_NE(open, stage.render(view, full, kWidth, kHeight).read_accessibility());
    view.options.occluding_opacity.reset();
    EXPECT_NE(open, stage.render(view, half, kWidth, kHeight).read_accessibility());
}

TEST_F(ShownFrame, ItsAccessibilityIsFittedAsItIsShown) {
    MeasuredScene stage(request_);
    const MeasuredView view = views_of(request_, study_, catalogue_).at(0);
    for (const stimuli::Condition& condition : study_.conditions) {
        EXPECT_EQ(stage.render(view, condition.b, kWidth, kHeight).read_accessibility(),
                  stage.render_plainly(view, condition.b, kWidth, kHeight).read_accessibility());
    }
}

}  // namespace
}  // namespace obscura::app
