// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "renderer/gl/context.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using tests::choice_of;

constexpr int kLitWidth = 97;
constexpr int kLitHeight = 63;

Variant in_pipeline(Variant choice, const std::string& pipeline) {
    choice.pipeline = pipeline;
    return choice;
}

std::vector<std::string> passes_of(const FramePlan& plan) {
    std::vector<std::string> names;
    for (const PlannedPass& pass : plan.passes) names.push_back(pass.name);
    return names;
}

Lighting sunlight() {
    Lighting lighting;
    lighting.lights.push_back({glm::normalize(glm::vec3(0.4F, 1.0F, 0.7F)), glm::vec3(1.6F)});
    return lighting;
}

class Pipelines : public testing::Test {
  protected:
    Frame render(const Variant& choice, const Lighting& lighting, int supersampling,
                 bool blended = true) {
        const Scene scene = tests::scene_of_all_kinds();
        const GpuScene gpu(scene);
        FrameOptions options;
        options.supersampling = supersampling;
        if (blended) options.occluding_opacity = 0.9F;
        Frame frame = renderer_.render({gpu, lighting, tests::forward_camera(), options}, choice,
                                       kLitWidth, kLitHeight);
        EXPECT_TRUE(renderer_.mismatches().empty()) << *renderer_.mismatches().begin();
        return frame;
    }

    HeadlessContext context_;
    Renderer renderer_;
};

TEST_F(Pipelines, BothShowTheSameImage) {
    // A G-buffer rounds albedo and normal to 8 bits before they are lit, a second drawing does not.
    constexpr int kRounding = 3;
    for (const char* technique : {"none", "blizzard", "gtao", "unsharp"}) {
        for (const int supersampling : {1, 2}) {
            for (const Lighting& lighting : {Lighting(), sunlight()}) {
                const Variant choice = choice_of(technique);
                const auto wanted =
                    render(in_pipeline(choice, "g-buffer"), lighting, supersampling).read_display();
                const auto found = render(in_pipeline(choice, "nd-buffer"), lighting, supersampling)
                                       .read_display();
                ASSERT_EQ(found.size(), wanted.size());
                std::size_t apart = 0;
                for (std::size_t i = 0; i < found.size(); ++i) {
                    if (std::abs(int{found[i]} - int{wanted[i]}) > kRounding) ++apart;
                }
                // At the edge of a shadow the rounding of a point decides.
                EXPECT_LE(apart, found.size() / 500) << technique << ", " << supersampling << "x, "
                                                     << lighting.lights.size() << " lights";
            }
        }
    }
}

TEST_F(Pipelines, TheTechniqueFindsTheSameInBoth) {
    for (const int supersampling : {1, 2}) {
        for (const std::string normal : {"rgb8", "oct16", "from-depth"}) {
            Variant choice = choice_of("gtao", "separable");
            choice.normal_format = normal;
            EXPECT_EQ(render(in_pipeline(choice, "nd-buffer"), sunlight(), supersampling)
                          .read_accessibility(),
                      render(in_pipeline(choice, "g-buffer"), sunlight(), supersampling)
                          .read_accessibility())
                << normal << ", " << supersampling << 'x';
        }
    }
}

TEST_F(Pipelines, AnNdBufferHoldsNormalAndDepthAlone) {
    const Frame frame = render(in_pipeline(choice_of("gtao"), "nd-buffer"), sunlight(), 1, false);
    EXPECT_THAT(passes_of(frame.plan()), testing::ElementsAre("geometry", "shadow", "accessibility",
                                                              "forward", "blend", "tone map"));
    EXPECT_EQ(frame.plan().find(Target::kAlbedo), nullptr);
    EXPECT_EQ(frame.plan().find(Target::kDirect), nullptr);
    EXPECT_NE(frame.plan().find(Target::kNormal), nullptr);
}

TEST_F(Pipelines, WithoutAccessibilityNothingIsDrawnTwice) {
    const Frame frame = render(in_pipeline(choice_of("none"), "nd-buffer"), sunlight(), 1);
    EXPECT_FALSE(frame.plan().has(Phase::kGeometry));
    EXPECT_TRUE(frame.plan().has(Phase::kForward));
}

TEST_F(Pipelines, BuffersThatAreWrittenBesideAnImageAreMadeInBoth) {
    const Scene scene = tests::scene_of_all_kinds();
    FrameOptions options;
    options.all_buffers = true;
    const FramePlan plan =
        plan_frame(needs_of(scene, sunlight()), in_pipeline(choice_of("gtao"), "nd-buffer"),
                   kLitWidth, kLitHeight, options);
    for (const Buffer& buffer :
         {Target::kAlbedo, Target::kNormal, Target::kDepth, Target::kDirect}) {
        EXPECT_NE(plan.find(buffer), nullptr) << buffer.name;
    }
}

}  // namespace
}  // namespace obscura::renderer
