// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// Steps as compute shaders: the same as when they are drawn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "renderer/base/error.h"
#include "renderer/denoise/denoise.h"
#include "renderer/gl/context.h"
#include "renderer/gl/program.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using testing::HasSubstr;

Scene boxes_before_nothing() {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -7.0F});
    for (int i = 0; i < 5; ++i) {
        const auto x = static_cast<float>(i - 2);
        tests::add_box(scene, {x, -1.0F, -6.0F + 0.3F * x}, {x + 0.6F, 0.3F * x, -5.3F + 0.3F * x});
    }
    return scene;
}

class ComputeSteps : public testing::Test {
  protected:
    std::vector<std::uint8_t> image(Renderer& renderer, const Variant& variant) {
        const Frame frame = renderer.render({gpu_, {}, tests::forward_camera()}, variant, 101, 67);
        EXPECT_THAT(renderer.mismatches(), testing::IsEmpty());
        return frame.read_bytes(frame.plan().makes_accessibility()
                                    ? frame.plan().final_accessibility()
                                    : frame.plan().image());
    }
    void expect_the_same(const Variant& variant) {
        EXPECT_EQ(image(fragments_, variant), image(compute_, variant)) << variant.in_words();
    }

    HeadlessContext context_;
    GpuScene gpu_{boxes_before_nothing()};
    Renderer fragments_{StepsBy::kFragments};
    Renderer compute_{StepsBy::kCompute};
};

TEST_F(ComputeSteps, OfEveryTechniqueWriteWhatFragmentsWrite) {
    for (const Technique& technique : techniques()) {
        if (technique.ray_traced) continue;
        expect_the_same(tests::choice_of(technique.name));
    }
}

TEST_F(ComputeSteps, OfEveryFilterWriteWhatFragmentsWrite) {
    for (const Denoise& filter : denoise_filters()) {
        expect_the_same(tests::choice_of("blizzard", filter.name));
    }
}

TEST_F(ComputeSteps, WriteEveryFormatSizeAndFrame) {
    Variant variant = tests::choice_of("gtao", "separable");
    variant.samples = 32;
    for (const char* format : {"r32f", "r16f", "r8"}) {
        for (const char* scale : {"1", "0.5", "0.25"}) {
            for (const char* frames : {"1", "2"}) {
                variant.ao_format = format;
                variant.ao_scale = scale;
                variant.frames = frames;
                expect_the_same(variant);
            }
        }
    }
}

TEST(ComputeSource, RefusesAShaderWithoutAnOutput) {
    try {
        (void)gl::compute_source("void main() {}\n", "toy/none.glsl");
        FAIL();
    } catch (const base::Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("toy/none.glsl"));
    }
}

TEST(StepsByDevice, IsWhatTheEnvironmentSaysAndNothingElse) {
    const HeadlessContext context;
    EXPECT_EQ(steps_by_device(), StepsBy::kFragments);  // where a processor draws
    setenv("OBSCURA_STEPS", "compute", 1);
    EXPECT_EQ(steps_by_device(), StepsBy::kCompute);
    setenv("OBSCURA_STEPS", "vertices", 1);
    try {
        (void)steps_by_device();
        ADD_FAILURE();
    } catch (const base::Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("vertices"));
        EXPECT_THAT(error.what(), HasSubstr("fragments"));
    }
    unsetenv("OBSCURA_STEPS");
}

}  // namespace
}  // namespace obscura::renderer
