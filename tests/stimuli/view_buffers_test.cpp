// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "renderer/frame/kept_shadows.h"
#include "renderer/gl/context.h"
#include "stimuli/stimulus.h"
#include "tests/support/test_scenes.h"

namespace obscura::stimuli {
namespace {

using renderer::Frame;
using renderer::PassTime;
using renderer::Phase;

/// Two views of the thesis's study whose conditions ask for every technique in turn, so that each
/// image meets the buffers of one that needed others.
Study study_of_all_techniques() {
    Study study = load_study("jakobsen2010");
    study.width = 160;
    study.height = 90;
    study.supersampling = 2;
    study.scenes = {study.scenes.front(), study.scenes.back()};
    study.conditions.clear();
    for (const StudyScene& scene : study.scenes) {
        for (const auto& [left, right] :
             {std::pair("none", "crytek"), {"blizzard", "raymarch"}, {"crytek", "none"}}) {
            Condition condition;
            condition.id = scene.id + "-" + left;
            condition.scene = scene.id;
            condition.a = tests::choice_of(left);
            condition.b = tests::choice_of(right);
            study.conditions.push_back(condition);
        }
    }
    return study;
}

TEST(ViewBuffers, AnImageOfAStudyThatTakesThemOverIsTheSameToTheByte) {
    const renderer::HeadlessContext context;
    const Study study = study_of_all_techniques();
    StimulusRenderer renderer(study);
    std::size_t taken_over = 0;
    for (const Stimulus& stimulus : stimuli_of(study)) {
        const Frame alone = renderer.render(stimulus);
        const Frame next = renderer.render_next(stimulus);
        EXPECT_TRUE(alone.taken_over().empty());
        taken_over += next.taken_over().size();
        EXPECT_TRUE(alone.read_display() == next.read_display()) << stimulus.file();
        ASSERT_EQ(next.times.size(), next.plan().passes.size()) << stimulus.file();
        for (std::size_t i = 0; i < next.times.size(); ++i) {
            EXPECT_EQ(next.times[i].name, next.plan().passes[i].name);
            EXPECT_GT(next.times[i].milliseconds, 0.0);
        }
    }
    EXPECT_GE(taken_over, 12U);
}

class TakenOver : public testing::Test {
  protected:
    Frame render(const renderer::Variant& choice, const renderer::FrameOptions& options,
                 const renderer::ViewBuffers& known = {}, int width = 32) {
        return renderer_.render({gpu_, lighting_, tests::forward_camera(), options}, choice, width,
                                32, known);
    }
    static bool has(const Frame& frame, Phase phase) {
        return std::any_of(frame.taken_over().begin(), frame.taken_over().end(),
                           [phase](const PassTime& time) { return time.phase == phase; });
    }

    renderer::HeadlessContext context_;
    renderer::Renderer renderer_;
    renderer::Scene scene_ = tests::facing_wall(4.0F);
    renderer::GpuScene gpu_{scene_};
    renderer::Lighting lighting_;
};

TEST_F(TakenOver, AnImageThatNobodyTimesIsTheSameToTheByteAndHasNoTimes) {
    for (const char* name : {"none", "blizzard", "gtao"}) {
        const auto render = [&](bool timed) {
            renderer::View view{gpu_, lighting_, tests::forward_camera()};
            view.timed = timed;
            return renderer_.render(view, tests::choice_of(name), 48, 32);
        };
        const Frame timed = render(true);
        const Frame untimed = render(false);
        EXPECT_TRUE(untimed.read_display() == timed.read_display()) << name;
        ASSERT_EQ(untimed.times.size(), timed.times.size()) << name;
        for (std::size_t i = 0; i < timed.times.size(); ++i) {
            EXPECT_EQ(untimed.times[i].name, timed.times[i].name);
            EXPECT_EQ(untimed.times[i].milliseconds, 0.0) << untimed.times[i].name;
        }
    }
}

TEST_F(TakenOver, AnImageThatMayBeStoppedIsTheSameToTheByteAndLeavesNothingWhereItIs) {
    const renderer::Scene scene = tests::scene_of_all_kinds();
    const renderer::GpuScene gpu(scene);
    renderer::Lighting lighting;
    lighting.environment = std::make_shared<renderer::Environment>(renderer::make_sky({}, 32));
    lighting.lights.push_back({glm::vec3(0.4F, 0.8F, 0.4F), glm::vec3(3.0F)});
    renderer::View view{gpu, lighting, tests::forward_camera(), {.supersampling = 2}};
    for (const char* name : {"none", "blizzard", "unsharp"}) {
        const auto render = [&] { return renderer_.render(view, tests::choice_of(name), 53, 75); };
        view.go_on = {};
        const std::vector<std::uint8_t> whole = render().read_display();
        int asked = 0;
        view.go_on = [&asked] { return ++asked > 0; };
        EXPECT_TRUE(render().read_display() == whole) << name;
        ASSERT_GT(asked, 10) << name;
        for (int stop = 1; stop <= asked; ++stop) {
            int left = stop;
            view.go_on = [&left] { return --left > 0; };
            EXPECT_THROW((void)render(), renderer::Stopped) << name << ' ' << stop;
        }
        view.go_on = {};
        EXPECT_TRUE(render().read_display() == whole) << name;
    }
}

TEST_F(TakenOver, MakesNoDifferenceToAnyBuffer) {
    const renderer::Scene scene = tests::scene_of_all_kinds();
    const renderer::GpuScene gpu(scene);
    renderer::Lighting lighting;
    lighting.environment = std::make_shared<renderer::Environment>(renderer::make_sky({}, 32));
    for (const renderer::FrameOptions& options : {renderer::FrameOptions{},
                                                  {.supersampling = 2},
                                                  {.occluding_opacity = 0.9F},
                                                  {.supersampling = 3, .occluding_opacity = 0.9F},
                                                  {.all_buffers = true}}) {
        renderer::ViewBuffers known;
        lighting.lights.clear();
        if (options.all_buffers) {  // one of them with a shadow map is enough, they are large
            lighting.lights.push_back({glm::vec3(0.4F, 0.8F, 0.4F), glm::vec3(3.0F)});
        }
        const auto half_open = [](const renderer::Camera&, int width, int height,
                                  const renderer::Variant&) {
            return std::vector<float>(static_cast<std::size_t>(width * height), 0.5F);
        };
        for (const char* name : {"none", "blizzard", "reference", "crytek", "raymarch", "none"}) {
            const renderer::Variant choice = tests::choice_of(name);
            const auto render = [&](const renderer::ViewBuffers& from) {
                return renderer_.render(
                    {gpu, lighting, tests::forward_camera(), options, half_open}, choice, 48, 32,
                    from);
            };
            const Frame alone = render({});
            const Frame next = render(known);
            EXPECT_EQ(next.taken_over().empty(), known.times.empty()) << name;
            for (const renderer::PlannedTarget& planned : alone.plan().targets) {
                if (planned.layers > 1) continue;
                EXPECT_TRUE(alone.read_bytes(planned) == next.read_bytes(planned))
                    << name << ": " << planned.name;
            }
            known = next.view_buffers();
        }
    }
}

TEST_F(TakenOver, ArePassesWhoseBuffersAreAllThere) {
    const Frame crytek = render({"crytek", 24, {}, "none"}, {});
    EXPECT_TRUE(
        has(render({"crytek", 8, {}, "none"}, {}, crytek.view_buffers()), Phase::kGeometry));
    // The normal that Blizzard reads is missing; None needs less than there is.
    EXPECT_FALSE(
        has(render({"blizzard", 24, {}, "none"}, {}, crytek.view_buffers()), Phase::kGeometry));
    EXPECT_TRUE(has(render({"none", 0, {}, "none"}, {}, crytek.view_buffers()), Phase::kGeometry));
    EXPECT_FALSE(
        has(render({"crytek", 24, {}, "none"}, {}, crytek.view_buffers()), Phase::kTechnique));
}

TEST_F(TakenOver, IsNothingOfAnotherSizeFormatOrOption) {
    const Frame crytek = render({"crytek", 24, {}, "none"}, {});
    EXPECT_TRUE(render({"crytek", 24, {}, "none"}, {.supersampling = 2}, crytek.view_buffers())
                    .taken_over()
                    .empty());
    EXPECT_TRUE(
        render({"crytek", 24, {}, "none"}, {.occluding_opacity = 0.5F}, crytek.view_buffers())
            .taken_over()
            .empty());
    EXPECT_TRUE(
        render({"crytek", 24, {}, "none"}, {}, crytek.view_buffers(), 33).taken_over().empty());
    renderer::Variant half{"crytek", 24, {}, "none"};
    half.depth_format = "r16f";
    EXPECT_TRUE(render(half, {}, crytek.view_buffers()).taken_over().empty());
}

TEST_F(TakenOver, AreShadowsAloneWhereOnlyTheCameraMoved) {
    const renderer::Scene scene = tests::scene_of_all_kinds();
    const renderer::GpuScene gpu(scene);
    lighting_.lights.push_back({glm::vec3(0.4F, 0.8F, 0.4F), glm::vec3(3.0F)});
    const renderer::Variant choice = tests::choice_of("blizzard");
    renderer::Camera camera = tests::forward_camera();
    const Frame first = renderer_.render({gpu, lighting_, camera}, choice, 48, 32);
    const renderer::ViewBuffers shadows = renderer::shadows_of(first.view_buffers());
    camera.position_m += glm::vec3(0.3F, 0.1F, 0.2F);
    const renderer::FrameOptions options{.supersampling = 2, .all_buffers = true};
    const Frame alone = renderer_.render({gpu, lighting_, camera, options}, choice, 40, 24);
    const Frame next = renderer_.render({gpu, lighting_, camera, options}, choice, 40, 24, shadows);
    EXPECT_TRUE(has(next, Phase::kShadow));
    EXPECT_EQ(next.taken_over().size(), 1U);
    for (const renderer::PlannedTarget& planned : alone.plan().targets) {
        EXPECT_TRUE(alone.read_bytes(planned) == next.read_bytes(planned)) << planned.name;
    }
}

}  // namespace
}  // namespace obscura::stimuli
