// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What recipes can say, shown by techniques that are made for the test and are in no list.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "renderer/base/error.h"
#include "renderer/denoise/denoise.h"
#include "renderer/frame/explain.h"
#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/reference.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kWidth = 64;
constexpr int kHeight = 48;

Technique technique_of(const char* name, Output output, Recipe (*recipe)(const Variant&)) {
    Technique technique;
    technique.name = name;
    technique.variant = name;
    technique.citation = "a test";
    technique.output = output;
    technique.recipe = recipe;
    return technique;
}

/// A depth mip chain, a buffer of half the size, and an upsample.
Recipe pyramid(const Variant&) {
    Recipe recipe;
    recipe.buffers = {{.name = "depth chain", .format = "r32f", .levels = 4},
                      {.name = "half", .format = "r16f", .scale = 0.5F}};
    Step top{"chain top", "toy/top.glsl", {Target::kDepth}, "depth chain", {}, 1, Cover::kAll};
    top.levels = 1;
    Step chain{"chain", "toy/chain.glsl", {"depth chain"}, "depth chain", {}, 4, Cover::kAll};
    chain.first_level = 1;
    recipe.steps = {
        top,
        chain,
        {"half", "toy/half.glsl", {{"depth chain", "chain"}}, "half", {"LEVEL 2"}, 1, Cover::kAll},
        {"upsample", "toy/upsample.glsl", {"half"}, "accessibility", {}, 1},
    };
    return recipe;
}

/// The depth parted into four layers of half the size, and put together again.
Recipe parted(const Variant&) {
    Recipe recipe;
    recipe.buffers = {{.name = "parts", .format = "r32f", .scale = 0.5F, .layers = 4}};
    recipe.steps = {
        {"part", "toy/part.glsl", {Target::kDepth}, "parts", {}, 1, Cover::kAll},
        {"join", "toy/join.glsl", {"parts"}, "accessibility", {}, 1},
    };
    return recipe;
}

/// The image with half its light.
Recipe halved(const Variant&) {
    Recipe recipe;
    recipe.steps = {{"halve", "toy/halve.glsl", {Target::kColour}, "colour", {}, 1, Cover::kAll}};
    return recipe;
}

/// The mean of two frames, 0.25 and 0.75.
Recipe averaged(const Variant&) {
    Recipe recipe;
    recipe.frames = 2;
    recipe.steps = {{"average", "toy/average.glsl", {Target::kHistory}, "accessibility", {}, 1}};
    return recipe;
}

const std::pair<const char*, const char*> kShaders[] = {
    {"top.glsl", R"(uniform sampler2D t_depth;
out float o;
void main() { o = texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r; }
)"},
    {"chain.glsl", R"(uniform sampler2D t_depth_chain;  // the level above
out float o;
void main() {
    ivec2 first = 2 * ivec2(gl_FragCoord.xy);
    o = 0.0;
    for (int i = 0; i < 4; ++i) {
        o += 0.25 * texelFetch(t_depth_chain, first + ivec2(i & 1, i >> 1), 0).r;
    }
}
)"},
    {"half.glsl", R"(uniform sampler2D t_chain;
out float o;
void main() {
    vec2 uv = gl_FragCoord.xy / vec2(textureSize(t_chain, 1));
    o = min(textureLod(t_chain, uv, float(LEVEL)).r * 0.01, 1.0);
}
)"},
    {"upsample.glsl", R"(uniform sampler2D t_half;
out float o;
void main() { o = texelFetch(t_half, ivec2(gl_FragCoord.xy) / 2, 0).r; }
)"},
    {"part.glsl", R"(uniform sampler2D t_depth;
uniform int u_layer;
out float o;
void main() {
    o = texelFetch(t_depth, 2 * ivec2(gl_FragCoord.xy) + ivec2(u_layer & 1, u_layer >> 1), 0).r;
}
)"},
    {"join.glsl", R"(uniform sampler2DArray t_parts;
out float o;
void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    o = texelFetch(t_parts, ivec3(here / 2, (here.x & 1) + 2 * (here.y & 1)), 0).r / 128.0;
}
)"},
    {"halve.glsl", R"(uniform sampler2D t_colour;
out vec4 o;
void main() { o = vec4(0.5 * texelFetch(t_colour, ivec2(gl_FragCoord.xy), 0).rgb, 1.0); }
)"},
    {"average.glsl", R"(uniform sampler2D t_history;
uniform int u_frame;
out float o;
void main() {
    float before = texelFetch(t_history, ivec2(gl_FragCoord.xy), 0).r;
    o = mix(before, u_frame == 0 ? 0.25 : 0.75, 1.0 / float(u_frame + 1));
}
)"},
    {"unknown.glsl", R"(uniform float u_unknown;
out float o;
void main() { o = u_unknown; }
)"},
};

class Recipes : public testing::Test {
  protected:
    Recipes() {
        // Shaders are read from a folder that has the house's and those of this test.
        const fs::path shaders = folder_.path() / "shaders";
        fs::copy(fs::path(OBSCURA_SOURCE_DIR) / "renderer", shaders, fs::copy_options::recursive);
        fs::create_directory(shaders / "toy");
        for (const auto& [name, text] : kShaders) std::ofstream(shaders / "toy" / name) << text;
        setenv("OBSCURA_SHADERS", shaders.c_str(), 1);
    }
    ~Recipes() override { unsetenv("OBSCURA_SHADERS"); }

    FramePlan plan(const Technique& technique, const FrameOptions& options = {}) {
        Variant variant;
        variant.technique = technique.name;
        return plan_frame(needs_of(scene_, lighting_), technique, variant, kWidth, kHeight,
                          options);
    }
    Frame draw(const Technique& technique, const FrameOptions& options = {}) {
        return renderer_.draw({gpu_, lighting_, tests::forward_camera(), options},
                              plan(technique, options));
    }
    Frame draw_none() {
        return renderer_.render({gpu_, lighting_, tests::forward_camera()}, Variant{}, kWidth,
                                kHeight);
    }

    tests::TemporaryFolder folder_;
    HeadlessContext context_;
    Renderer renderer_;
    Lighting lighting_;
    Scene scene_ = [] {
        Scene scene = tests::empty_scene();
        tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {0.5F, 0.5F, -4.0F});
        tests::add_quad(scene, {-3.0F, -1.0F, -1.0F}, {9.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -9.0F});
        return scene;
    }();
    GpuScene gpu_{scene_};
};

/// What the passes of a frame are called, those of the technique and the filter only.
std::vector<std::string> step_names(const Frame& frame) {
    std::vector<std::string> names;
    for (const PassTime& time : frame.times) {
        if (is_of_the_variant(time.phase)) names.push_back(time.name);
        EXPECT_GT(time.milliseconds, 0.0) << time.name;
    }
    return names;
}

std::size_t at(int x, int y, int width = kWidth) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
}

TEST_F(Recipes, CarryADepthMipChainHalfSizeAndAnUpsample) {
    const Frame frame = draw(technique_of("Pyramid", Output::kAccessibility, pyramid));
    std::vector<float> above = frame.read_floats(Target::kDepth);
    EXPECT_EQ(frame.read_components("depth chain", 1, 0), above);
    for (int level = 1; level < 4; ++level) {
        const int width = kWidth >> level;
        const std::vector<float> found = frame.read_components("depth chain", 1, level);
        ASSERT_EQ(found.size(), static_cast<std::size_t>(width * (kHeight >> level)));
        for (int y = 0; y < kHeight >> level; ++y) {
            for (int x = 0; x < width; ++x) {
                double mean = 0.0;
                for (int i = 0; i < 4; ++i) {
                    mean += 0.25 * above[at(2 * x + i % 2, 2 * y + i / 2, 2 * width)];
                }
                ASSERT_NEAR(found[at(x, y, width)] / mean, 1.0, 1e-6) << level << ": " << x << y;
            }
        }
        above = found;
    }
    const std::vector<float> quarter = frame.read_components("depth chain", 1, 2);
    const std::vector<float> half = frame.read_floats("half");
    ASSERT_EQ(half.size(), at(0, kHeight / 2, kWidth / 2));
    const std::vector<float> open = frame.read_accessibility();
    const std::vector<float> depth_m = frame.read_floats(Target::kDepth);
    std::size_t empty = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const float expected = std::min(quarter[at(x / 4, y / 4, kWidth / 4)] * 0.01F, 1.0F);
            ASSERT_NEAR(half[at(x / 2, y / 2, kWidth / 2)], expected, 1e-4F);
            const bool is_empty = depth_m[at(x, y)] >= kBackgroundLimit_m;
            empty += is_empty ? 1 : 0;
            ASSERT_EQ(open[at(x, y)], is_empty ? 1.0F : half[at(x / 2, y / 2, kWidth / 2)]);
        }
    }
    EXPECT_GT(empty, 100U);
    EXPECT_LT(empty, open.size() - 100U);
    EXPECT_THAT(step_names(frame), testing::ElementsAre("chain top", "chain", "half", "upsample"));
    const std::string text = explanation_of(frame);
    EXPECT_THAT(text, HasSubstr("  pass    chain top "));
    // 4 bytes of 64x48, 32x24, 16x12 and 8x6 texels; 2 bytes of 32x24.
    EXPECT_THAT(text, HasSubstr("depth chain        16320 bytes  r32f 64x48, 4 levels"));
    EXPECT_THAT(text, HasSubstr("half                1536 bytes  r16f 32x24"));
    // Of the image's pixels: 1, 4 (1/4 + 1/16 + 1/64), 1/4 and 1.
    EXPECT_EQ(fetches_per_pixel(pyramid({})), 4);
}

TEST_F(Recipes, CarryFourLayers) {
    const Frame frame = draw(technique_of("Parted", Output::kAccessibility, parted));
    const std::vector<float> depth_m = frame.read_floats(Target::kDepth);
    const std::vector<float> open = frame.read_accessibility();
    for (std::size_t i = 0; i < open.size(); ++i) {
        ASSERT_EQ(open[i], depth_m[i] < kBackgroundLimit_m ? depth_m[i] / 128.0F : 1.0F);
    }
    EXPECT_EQ(frame.read_components("parts", 1).size(), depth_m.size());
    EXPECT_THAT(step_names(frame), testing::ElementsAre("part", "join"));
    EXPECT_THAT(explanation_of(frame), HasSubstr("parts              12288 bytes  r32f 32x24x4\n"));
}

TEST_F(Recipes, CarryWhatMakesColourOfColourBeforeTheToneCurve) {
    lighting_.ambient = glm::vec3(0.6F, 0.4F, 0.2F);
    const std::vector<float> whole = [&] {
        Lighting same = lighting_;
        same.tone_mapping = ToneMapping{1.0F, 1.0F, ToneCurve::kClip};
        return renderer_.render({gpu_, same, tests::forward_camera()}, Variant{}, kWidth, kHeight)
            .read_components(Target::kHdr, 3);
    }();
    const Frame frame = draw(technique_of("Halved", Output::kColour, halved));
    const std::vector<float> half = frame.read_components(Target::kColour, 3);
    ASSERT_EQ(half.size(), whole.size());
    for (std::size_t i = 0; i < half.size(); ++i) ASSERT_EQ(half[i], 0.5F * whole[i]);
    EXPECT_NE(frame.read_display(), draw_none().read_display());
    EXPECT_THAT(frame.read_accessibility(), testing::Each(1.0F));
    EXPECT_THAT(step_names(frame), testing::ElementsAre("halve"));
    std::vector<std::string> names;
    for (const PassTime& time : frame.times) names.push_back(time.name);
    EXPECT_THAT(names, testing::ElementsAre("geometry", "composite", "halve", "tone map"));
    EXPECT_THAT(explanation_of(frame), HasSubstr("without denoise: there is no accessibility"));
}

TEST_F(Recipes, OfColourRunForEverySampleAndUnderWhatIsSeenThrough) {
    scene_ = tests::scene_of_all_kinds();
    gpu_ = GpuScene(scene_);
    const Technique technique = technique_of("Halved", Output::kColour, halved);
    const Frame frame = draw(technique, {.supersampling = 2, .occluding_opacity = 0.9F});
    EXPECT_EQ(frame.plan().find(Target::kColour)->width, 2 * kWidth);
    EXPECT_EQ(frame.plan().find(Target::kOccluderDepth), nullptr);
    std::vector<std::string> names;
    for (const PassTime& time : frame.times) names.push_back(time.name);
    EXPECT_THAT(names, testing::ElementsAre("geometry", "composite", "halve", "blend", "tone map",
                                            "resolve"));
}

TEST_F(Recipes, CarryTwoFramesOfWhichTheSecondKnowsTheFirst) {
    const Frame frame =
        draw(technique_of("Averaged", Output::kAccessibility, averaged), {.all_buffers = true});
    const std::vector<float> depth_m = frame.read_floats(Target::kDepth);
    const std::vector<float> open = frame.read_accessibility();
    for (std::size_t i = 0; i < open.size(); ++i) {
        ASSERT_EQ(open[i], depth_m[i] < kBackgroundLimit_m ? 0.5F : 1.0F);
    }
    EXPECT_THAT(step_names(frame),
                testing::ElementsAre("history", "average", "history", "average"));
    EXPECT_THAT(explanation_of(frame), HasSubstr("  buffer  history "));
    EXPECT_EQ(fetches_per_pixel(averaged({})), 2);
}

TEST_F(Recipes, LeaveNothingUnsaidBetweenStepsAndShaders) {
    for (const auto& [recipe, output] : {std::pair(&pyramid, Output::kAccessibility),
                                         {parted, Output::kAccessibility},
                                         {halved, Output::kColour},
                                         {averaged, Output::kAccessibility}}) {
        (void)draw(technique_of("Toy", output, recipe), {.supersampling = 2});
    }
    EXPECT_THAT(renderer_.mismatches(), testing::IsEmpty());
}

TEST_F(Recipes, ThatNameWhatTheirShaderDoesNotReadAreNoticed) {
    (void)draw(technique_of("Toy", Output::kAccessibility, [](const Variant&) {
        Recipe recipe = averaged({});
        recipe.steps[0].reads.emplace_back(Target::kNormal);
        return recipe;
    }));
    EXPECT_THAT(
        renderer_.mismatches(),
        testing::ElementsAre("step average names t_normal, which toy/average.glsl does not read"));
}

TEST_F(Recipes, WhoseShaderReadsWhatNobodySetsAreNoticed) {
    (void)draw(technique_of("Toy", Output::kAccessibility, [](const Variant&) {
        Recipe recipe;
        recipe.steps = {{"unknown", "toy/unknown.glsl", {}, "accessibility", {}, 0}};
        return recipe;
    }));
    EXPECT_THAT(renderer_.mismatches(),
                testing::ElementsAre("toy/unknown.glsl reads u_unknown, which nobody sets"));
}

TEST_F(Recipes, WithAParameterThatNoStepReadsAreNoticed) {
    Technique technique = technique_of("Toy", Output::kAccessibility, averaged);
    technique.parameters = {{"radius_m", "", "m", 0.0, 1.0, 0.5}};
    (void)draw(technique);
    EXPECT_THAT(renderer_.mismatches(), testing::ElementsAre("no step of Toy reads p_radius_m"));
}

TEST_F(Recipes, ThatReadOrWriteWhatThereIsNotAreRefused) {
    const auto refusal = [this](Recipe (*recipe)(const Variant&)) -> std::string {
        try {
            (void)plan(technique_of("Toy", Output::kAccessibility, recipe));
        } catch (const base::Error& error) {
            return error.what();
        }
        return "planned";
    };
    EXPECT_THAT(refusal([](const Variant&) {
                    Recipe recipe = parted({});
                    recipe.steps[0].writes = "part";
                    return recipe;
                }),
                HasSubstr("step \"part\" writes \"part\""));
    EXPECT_THAT(refusal([](const Variant&) {
                    Recipe recipe = parted({});
                    recipe.steps.erase(recipe.steps.begin());
                    return recipe;
                }),
                HasSubstr("step \"join\" reads \"parts\""));
    EXPECT_THAT(refusal([](const Variant&) {
                    Recipe recipe = parted({});
                    recipe.steps[0].cover = Cover::kSurfaces;
                    return recipe;
                }),
                HasSubstr("covers surfaces only"));
    EXPECT_THAT(refusal([](const Variant&) {
                    Recipe recipe = pyramid({});
                    recipe.steps[1].first_level = 0;
                    return recipe;
                }),
                HasSubstr("begins with the first"));
    EXPECT_THAT(refusal([](const Variant&) {
                    Recipe recipe = parted({});
                    recipe.buffers[0].format = "r24";
                    return recipe;
                }),
                HasSubstr("r32f"));
}

class EveryTechnique : public testing::Test {
  protected:
    HeadlessContext context_;
    Renderer renderer_;
};

TEST_F(EveryTechnique, AndFilterSaysWhatItsShadersReadAndNoMore) {
    const Scene scene = tests::scene_of_all_kinds();
    const GpuScene gpu(scene);
    Lighting lighting;
    lighting.environment = std::make_shared<Environment>(make_sky({}, 32));
    lighting.lights.push_back({glm::vec3(0.4F, 0.8F, 0.4F), glm::vec3(3.0F)});
    const auto traced = [](const Camera&, int width, int height, const Variant&) {
        return std::vector<float>(static_cast<std::size_t>(width * height), 0.5F);
    };
    const ReferenceScene made(scene);
    const auto rays = [&made]() -> const ReferenceScene& { return made; };
    int drawn = 0;
    for (const Technique& technique : techniques()) {
        for (const Denoise& denoise : denoise_filters()) {
            Variant variant = standard_variant(technique);
            variant.denoise = denoise.name;
            if (!problems_of(variant).empty()) continue;
            for (const FrameOptions& options :
                 {FrameOptions{}, {.supersampling = 2, .occluding_opacity = 0.9F}}) {
                (void)renderer_.render(
                    {gpu, lighting, tests::forward_camera(), options, traced, rays}, variant, 32,
                    24);
                ++drawn;
            }
        }
    }
    EXPECT_GT(drawn, static_cast<int>(techniques().size()));
    EXPECT_THAT(renderer_.mismatches(), testing::IsEmpty());
}

TEST_F(EveryTechnique, NamesItsBuffersAndStepsOtherwiseThanTheHouse) {
    std::vector<Recipe> recipes;
    for (const Technique& technique : techniques()) recipes.push_back(technique.standard_recipe());
    for (const Denoise& denoise : denoise_filters()) recipes.push_back(denoise.recipe);
    for (const Recipe& recipe : recipes) {
        for (const Buffer& buffer : recipe.buffers) {
            for (const Buffer& house :
                 {Target::kAlbedo, Target::kNormal, Target::kDepth, Target::kVisibility,
                  Target::kAccessibility, Target::kHistory, Target::kDenoised, Target::kHdr,
                  Target::kColour, Target::kDisplay}) {
                EXPECT_FALSE(buffer.is(house)) << buffer.name;
            }
        }
        for (const Step& step : recipe.steps) EXPECT_GT(step.fetches, 0) << step.name;
    }
}

}  // namespace
}  // namespace obscura::renderer
