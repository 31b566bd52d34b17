// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <memory>

#include "renderer/base/files.h"
#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/reference.h"
#include "stimuli/generate.h"
#include "stimuli/png.h"
#include "stimuli/stimulus.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scenes.h"

namespace obscura::stimuli {
namespace {

renderer::Scene build_coloured_block() {
    renderer::Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.6F, 0.4F, 0.2F);
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -40.0F});
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 0.5F, -4.0F});
    scene.cameras.push_back(tests::forward_camera());
    return scene;
}

renderer::Lighting light_coloured_block(Validity validity) {
    renderer::Lighting lighting;
    lighting.ambient = glm::vec3(0.5F);
    if (validity == Validity::kLow) return lighting;
    lighting.environment = std::make_shared<renderer::Environment>(renderer::make_sky({}, 64));
    lighting.lights.push_back({glm::normalize(glm::vec3(1.0F, 2.0F, 1.0F)), glm::vec3(3.0F)});
    lighting.tone_mapping = renderer::ToneMapping{1.5F, 3.0F, renderer::ToneCurve::kFilmic};
    return lighting;
}

const std::vector<BuiltinScene>& buffers_catalogue() {
    static const std::vector<BuiltinScene> list = {{"block",
                                                    "A block on a floor",
                                                    "nothing",
                                                    {Validity::kLow, Validity::kHigh},
                                                    {"forward"},
                                                    build_coloured_block,
                                                    light_coloured_block}};
    return list;
}

Study study_of_blocks() {
    Study study;
    study.name = "blocks";
    study.width = 96;
    study.height = 54;
    study.scenes = {{"low", "block", "forward", Validity::kLow},
                    {"high", "block", "forward", Validity::kHigh}};
    Condition first;
    first.id = "I";
    first.scene = "low";
    first.hypothesis = "H2";
    first.b = {"blizzard", 24, {}, "separable"};
    Condition second;
    second.id = "II";
    second.scene = "high";
    second.hypothesis = "H1";
    second.b = {"raymarch", 30, {}, "separable"};
    study.conditions = {first, second};
    return study;
}

TEST(Buffers, DepthIsWhatARayThroughThePixelsMiddleMeets) {
    const Study study = study_of_blocks();
    const renderer::HeadlessContext context;
    StimulusRenderer stimuli(study, buffers_catalogue());
    const Stimulus stimulus{&study.conditions[1], 'b'};
    const renderer::FloatImage image = stimuli.render_buffers(stimulus);
    const renderer::Scene scene = build_coloured_block();
    const renderer::ReferenceImage truth = renderer::ReferenceScene(scene).trace(
        scene.cameras[0], study.width, study.height, {.radius_m = 1.0, .rays = 1});
    const std::vector<float>& depth_m = *image.find("Z");
    ASSERT_EQ(depth_m.size(), truth.depth_m.size());
    int compared = 0;
    for (std::size_t i = 0; i < depth_m.size(); ++i) {
        if (depth_m[i] >= kBackgroundLimit_m) continue;
        EXPECT_NEAR(depth_m[i] / truth.depth_m[i], 1.0, 1e-4) << "pixel " << i;
        ++compared;
    }
    EXPECT_GT(compared, 2000);
}

TEST(Buffers, ChannelsAndMatricesLeadFromAPixelBackToItsSurface) {
    const Study study = study_of_blocks();
    const renderer::HeadlessContext context;
    StimulusRenderer stimuli(study, buffers_catalogue());
    const Stimulus stimulus{&study.conditions[0], 'b'};
    const renderer::FloatImage image = stimuli.render_buffers(stimulus);
    const glm::mat4 view = glm::make_mat4(image.matrices.at("obscura:view").data());
    const glm::mat4 projection = glm::make_mat4(image.matrices.at("obscura:projection").data());
    // The floor lies at y = -1: two rows above the lower border, in the middle.
    const std::size_t at = static_cast<std::size_t>(51) * 96 + 48;
    const glm::vec2 clip((48.5F / 96.0F) * 2.0F - 1.0F, 1.0F - (51.5F / 54.0F) * 2.0F);
    glm::vec4 ray = glm::inverse(projection) * glm::vec4(clip, 1.0F, 1.0F);
    ray /= -ray.z;
    const float z = (*image.find("Z"))[at];
    const glm::vec4 world = glm::inverse(view) * glm::vec4(glm::vec3(ray) * z, 1.0F);
    EXPECT_NEAR(world.y, -1.0F, 1e-3F);
    EXPECT_NEAR((*image.find("N.Y"))[at], 1.0F, 0.02F);
    EXPECT_NEAR((*image.find("albedo.R"))[at], 0.6F, 0.01F);
    EXPECT_NEAR((*image.find("albedo.B"))[at], 0.2F, 0.01F);
    EXPECT_FLOAT_EQ((*image.find("light.G"))[at], 0.5F);
    EXPECT_GT((*image.find("ao.Y"))[at], 0.5F);
    // The sky: nothing is there.
    EXPECT_EQ((*image.find("Z"))[0], kBackgroundDepth_m);
    EXPECT_EQ((*image.find("ao.Y"))[0], 1.0F);
    EXPECT_EQ((*image.find("N.Y"))[0], 0.0F);
    EXPECT_EQ((*image.find("light.G"))[0], 0.0F);
}

TEST(Buffers, TheLightOfAPairIsTheSame) {
    const Study study = study_of_blocks();
    const renderer::HeadlessContext context;
    StimulusRenderer stimuli(study, buffers_catalogue());
    const renderer::FloatImage a = stimuli.render_buffers({&study.conditions[1], 'a'});
    const renderer::FloatImage b = stimuli.render_buffers({&study.conditions[1], 'b'});
    for (const char* channel : {"Z", "N.X", "N.Y", "N.Z", "albedo.R", "light.R", "light.B"}) {
        EXPECT_EQ(*a.find(channel), *b.find(channel)) << channel;
    }
    EXPECT_NE(*a.find("ao.Y"), *b.find("ao.Y"));
}

TEST(Buffers, AFrameThatLeavesNothingOutShowsTheSameSurfaces) {
    const Study study = study_of_blocks();
    const renderer::HeadlessContext context;
    StimulusRenderer stimuli(study, buffers_catalogue());
    for (const Condition& condition : study.conditions) {
        const Stimulus stimulus{&condition, 'b'};
        const renderer::Frame planned = stimuli.render(stimulus);
        const renderer::Frame everything = stimuli.render_everything(stimulus);
        EXPECT_GT(everything.plan().bytes(), planned.plan().bytes());
        const std::vector<std::uint8_t> wanted = planned.read_display();
        const std::vector<std::uint8_t> met = everything.read_display();
        const std::vector<float> depth_m = everything.read_floats(renderer::Target::kDepth);
        for (int y = 0; y < study.height; ++y) {
            for (int x = 0; x < study.width; ++x) {
                const auto i = static_cast<std::size_t>(y) * study.width + x;
                if (depth_m[i] >= kBackgroundLimit_m) continue;
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(met[3 * i + c], wanted[3 * i + c], 2);
            }
        }
    }
}

TEST(Buffers, AreWrittenBesideTheImageWhereAskedFor) {
    const tests::TemporaryFolder folder;
    const Study study = study_of_blocks();
    Selection selection;
    selection.buffers = true;
    selection.condition = "II";
    (void)generate(study, selection, folder.path(), true, buffers_catalogue());
    const renderer::FloatImage image =
        renderer::decode_exr(base::read_file(folder.path() / "II-b.exr"), "II-b.exr");
    EXPECT_EQ(image.width, 96);
    EXPECT_NE(image.find("N.Z"), nullptr);
    EXPECT_EQ(image.texts.at("obscura:variant"), "RayMarching30");
}

TEST(SupersampledStudy, GivesAnImageOfTheStudysSizeThatTheManifestRecords) {
    const tests::TemporaryFolder folder;
    Study study = study_of_blocks();
    study.supersampling = 2;
    (void)generate(study, {}, folder.path(), true, buffers_catalogue());
    EXPECT_TRUE(problems_of_stimuli(study, folder.path()).empty());
    const RgbImage image = decode_png(base::read_file(folder.path() / "II-b.png"), "II-b.png");
    EXPECT_EQ(image.width, 96);
    EXPECT_EQ(image.height, 54);
    const Manifest manifest = load_manifest(folder.path() / "manifest.json");
    const ManifestImage& entry = *manifest.find("II", "b");
    EXPECT_EQ(entry.supersampling, 2);
    EXPECT_EQ(entry.tone_mapping.curve, "filmic");
    EXPECT_DOUBLE_EQ(entry.tone_mapping.exposure, 1.5);
    EXPECT_TRUE(manifest.find("I", "a")->tone_mapping.curve.empty());
    // The same image with one sample a pixel is another one, and the manifest's no longer holds.
    study.supersampling = 1;
    EXPECT_FALSE(problems_of_stimuli(study, folder.path()).empty());
}

TEST(OccludingOpacity, OfTheStudyReachesThePlanAndTheManifest) {
    Study study = study_of_blocks();
    study.occluding_opacity = 0.8F;
    const renderer::HeadlessContext context;
    StimulusRenderer stimuli(study, buffers_catalogue());
    const Stimulus stimulus{&study.conditions[1], 'b'};
    const renderer::Frame frame = stimuli.render(stimulus);
    EXPECT_EQ(frame.plan().options.occluding_opacity, 0.8F);
    EXPECT_EQ(stimuli.describe(stimulus, frame).occluding_opacity, 0.8F);
    EXPECT_TRUE(shows_what_is_asked(study, stimuli.describe(stimulus, frame)));
    const std::string inputs = stimuli.inputs_sha256(stimulus);
    study.occluding_opacity.reset();
    EXPECT_NE(stimuli.inputs_sha256(stimulus), inputs);
}

}  // namespace
}  // namespace obscura::stimuli
