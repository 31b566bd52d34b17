// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/gl/context.h"
#include "renderer/hard_cases/agreement.h"
#include "renderer/hard_cases/bench.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/progressive.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using tests::choice_of;
using tests::facing_wall;
using tests::forward_camera;

class Techniques : public testing::TestWithParam<std::string> {
  protected:
    Frame render(const Scene& scene, const Variant& choice, int width, int height,
                 const Camera& camera = forward_camera()) {
        const Lighting lighting;
        const GpuScene gpu(scene);
        return renderer_.render({gpu, lighting, camera}, choice, width, height);
    }

    /// The accessibility in the middle of the image, where no sample leaves it.
    static std::vector<float> middle(const Frame& frame, int half = 8) {
        const std::vector<float> all = frame.read_floats(Target::kAccessibility);
        const int width = frame.plan().width;
        const int height = frame.plan().height;
        std::vector<float> values;
        for (int y = height / 2 - half; y < height / 2 + half; ++y) {
            for (int x = width / 2 - half; x < width / 2 + half; ++x) {
                values.push_back(all[static_cast<std::size_t>(y) * width + x]);
            }
        }
        return values;
    }

    HeadlessContext context_;
    Renderer renderer_;
};

using Computing = Techniques;

TEST_F(Techniques, AWallFacingTheCameraHasTheClosedFormOfEachDefinition) {
    EXPECT_EQ(find_technique("crytek")->facing_wall, 0.75);
    EXPECT_EQ(find_technique("blizzard")->facing_wall, 1.0);
    for (const Technique& technique : techniques()) {
        if (!technique.model) continue;
        const Frame frame = render(facing_wall(5.0F), choice_of(technique.name), 256, 256);
        const auto expected = static_cast<float>(technique.facing_wall);
        EXPECT_THAT(middle(frame), testing::Each(testing::FloatNear(expected, 1e-6F)))
            << technique.name;
    }
}

TEST_F(Techniques, EachThatAShaderComputesHasAModelAndAReachFromZero) {
    for (const Technique& technique : techniques()) {
        if (technique.ray_traced || !technique.makes_accessibility()) continue;
        if (technique.recipe == nullptr) continue;
        EXPECT_TRUE(technique.model) << technique.name;
        ASSERT_NE(technique.find_parameter(technique.reach), nullptr) << technique.name;
        EXPECT_EQ(technique.find_parameter(technique.reach)->low, 0.0) << technique.name;
    }
}

TEST(FittedValues, HaveNoUnitOfLengthAndAreAllowed) {
    int fitted = 0;
    for (const Technique& technique : techniques()) {
        Variant variant = standard_variant(technique);
        EXPECT_EQ(apply_preset("published", variant), "");
        EXPECT_EQ(variant, standard_variant(technique));
        EXPECT_NE(apply_preset("fited", variant), "");
        EXPECT_EQ(apply_preset("fitted", variant).empty(), !technique.fitted.empty());
        EXPECT_TRUE(problems_of(variant).empty()) << technique.name;
        for (const auto& [name, value] : technique.fitted) {
            const Parameter* parameter = technique.find_parameter(name);
            ASSERT_NE(parameter, nullptr) << technique.name << ", " << name;
            EXPECT_TRUE(parameter->fit && parameter->unit != "m") << technique.name << ", " << name;
            ++fitted;
        }
        Variant own = standard_variant(technique);
        for (const auto& [name, value] : technique.fitted) own.parameters[name] = 0.5;
        const Variant before = own;
        (void)apply_preset("fitted", own);
        EXPECT_EQ(own, before) << "what is set stays";
    }
    EXPECT_GT(fitted, 0);
}

TEST_P(Computing, EmptyPixelsAreExactlyOpen) {
    Scene scene = tests::empty_scene();
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 1.0F, -4.0F});
    const Frame frame = render(scene, choice_of(GetParam()), 160, 90);
    const std::vector<float> depth = frame.read_floats(Target::kDepth);
    const std::vector<float> open = frame.read_floats(Target::kAccessibility);
    int empty = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (depth[i] < kBackgroundLimit_m) continue;
        ++empty;
        ASSERT_EQ(open[i], 1.0F) << "pixel " << i;
    }
    EXPECT_GT(empty, 1000);
    EXPECT_LT(empty, 160 * 90);
}

TEST_P(Computing, EveryValueIsFiniteAndInRangeOnHardGeometry) {
    Scene scene = tests::empty_scene();
    // Edge-on quads, a zero-area triangle, normals of length zero, a surface at the near plane.
    tests::add_quad(scene, {-5.0F, -1.0F, -20.0F}, {10.0F, 0.0F, 0.0F}, {0.0F, 0.001F, 19.8F});
    tests::add_quad(scene, {-0.2F, -0.2F, -0.1001F}, {0.1F, 0.0F, 0.0F}, {0.0F, 0.1F, 0.0F});
    tests::add_box(scene, {0.2F, -1.0F, -3.0F}, {1.0F, 1.0F, -2.0F});
    tests::add_box(scene, {-1.0F, -1.0F, -90.0F}, {-0.5F, 1.0F, -2.0F});
    for (Vertex& vertex : scene.meshes.back().vertices) vertex.normal = glm::vec3(0.0F);
    for (std::size_t i = 0; i < 6; ++i) {
        for (Vertex& vertex : scene.meshes[2 + i].vertices) vertex.normal = -vertex.normal;
    }
    Mesh line = scene.meshes[0];
    for (Vertex& vertex : line.vertices) vertex.position_m = {0.0F, 0.0F, -4.0F};
    scene.meshes.push_back(line);
    for (const double radius : {0.0, 1e-8, 0.5, 1000.0}) {
        Variant choice = choice_of(GetParam());
        const Technique& technique = *find_technique(GetParam());
        const Parameter& reach = *technique.find_parameter(technique.reach);
        choice.parameters[reach.name] = std::min(radius, reach.high);
        const Frame frame = render(scene, choice, 121, 67);
        for (const float value : frame.read_floats(Target::kAccessibility)) {
            ASSERT_TRUE(std::isfinite(value) && value >= 0.0F && value <= 1.0F)
                << value << " at radius " << radius;
        }
    }
}

TEST_P(Computing, ACornerIsDarkerThanTheOpenWall) {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-20.0F, -1.0F, -6.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 20.0F, 0.0F});
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -6.0F});
    Variant choice = choice_of(GetParam());
    if (find_technique(GetParam())->find_parameter("power") != nullptr) {
        choice.parameters["power"] = 64.0;
    }
    const Frame frame = render(scene, choice, 256, 256);
    const std::vector<float> open = frame.read_floats(Target::kAccessibility);
    const std::vector<float> depth = frame.read_floats(Target::kDepth);
    // Down the middle column: the wall is where depth is 6 m; the corner is its lowest row.
    int corner_row = 0;
    for (int y = 0; y < 256; ++y) {
        if (std::abs(depth[static_cast<std::size_t>(y) * 256 + 128] - 6.0F) < 1e-3F) corner_row = y;
    }
    const auto mean_of_rows = [&open](int first, int last) {
        double sum = 0.0;
        for (int y = first; y < last; ++y) {
            for (int x = 120; x < 136; ++x) sum += open[static_cast<std::size_t>(y) * 256 + x];
        }
        return sum / (16.0 * (last - first));
    };
    EXPECT_LT(mean_of_rows(corner_row - 4, corner_row), mean_of_rows(120, 136) - 0.05);
}

TEST_P(Computing, TheSameFrameTwiceIsTheSameToTheByte) {
    const Frame first = render(facing_wall(3.0F), choice_of(GetParam()), 64, 48);
    const Frame second = render(facing_wall(3.0F), choice_of(GetParam()), 64, 48);
    for (const PlannedTarget& planned : first.plan().targets) {
        EXPECT_EQ(first.read_bytes(planned), second.read_bytes(planned)) << planned.name;
    }
}

TEST_P(Computing, OddSizesRenderToo) {
    for (const auto& [width, height] : {std::pair(1, 1), {17, 9}, {3, 200}}) {
        const Frame frame = render(facing_wall(3.0F), choice_of(GetParam()), width, height);
        for (const float value : frame.read_floats(Target::kAccessibility)) {
            ASSERT_TRUE(value >= 0.0F && value <= 1.0F) << width << "x" << height;
        }
    }
}

/// Boxes before a wall and on a floor, some tilted out of the axes by the camera.
Scene cluttered_scene() {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-20.0F, -1.0F, -9.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 8.0F, 0.0F});
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -9.0F});
    for (int i = 0; i < 6; ++i) {
        const auto x = static_cast<float>(i - 3);
        tests::add_box(scene, {x, -1.0F, -4.0F - 0.7F * x}, {x + 0.6F, 0.3F * x, -3.5F - 0.7F * x});
    }
    return scene;
}

TEST_P(Computing, EveryPixelIsWhatTheDefinitionGives) {
    Camera camera = forward_camera();
    camera.position_m = {0.6F, 1.4F, 0.5F};
    camera.target_m = {-0.2F, -0.3F, -4.0F};
    camera.far_m = 30.0F;
    camera.lens_shift = {0.1F, -0.2F};
    Variant choice = choice_of(GetParam());
    const Technique& technique = *find_technique(GetParam());
    for (const auto& [name, value] : {std::pair("offset_scale", 0.02),
                                      {"radius_m", 0.9},
                                      {"full_threshold_m", 0.03},
                                      {"no_threshold_m", 1.1},
                                      {"depth_scale_per_m", 1.2},
                                      {"power", 6.0}}) {
        if (technique.find_parameter(name) != nullptr) choice.parameters[name] = value;
    }
    for (const char* format : {"r32f", "r16f"}) {
        choice.depth_format = format;
        const Frame frame = render(cluttered_scene(), choice, 128, 96, camera);
        const SeenBuffers buffers = seen_buffers(frame, camera);
        const std::vector<float> measured = frame.read_floats(Target::kAccessibility);
        const Agreement found =
            agreement_of(admitted_by(technique.model(buffers, choice), buffers), measured, 128, "");
        EXPECT_EQ(found.off, 0U) << found.worst.where << ": defined " << found.worst.definition
                                 << ", measured " << found.worst.measured << ", allowed "
                                 << found.worst.allowed;
        EXPECT_EQ(found.pixels, 128U * 96U);
        EXPECT_LT(found.uncertain, found.pixels / 20);
        double sum = 0.0;
        for (const float value : measured) sum += value;
        EXPECT_LT(sum / (128.0 * 96.0), 0.98) << "nothing was occluded";
    }
}

TEST_P(Computing, EveryPixelIsWhatTheDefinitionGivesWithEveryOption) {
    const Technique& technique = *find_technique(GetParam());
    for (const VariantOption& option : variant_options()) {
        for (const std::string& word : option.allowed) {
            Variant choice = choice_of(GetParam());
            choice.*option.value = word;
            if (word == option.standard() || !problems_of(choice).empty()) continue;
            if (frames_of(choice) > 3) continue;  // as two or three are
            const Frame frame = render(cluttered_scene(), choice, 67, 47);
            const SeenBuffers buffers = seen_buffers(frame, forward_camera());
            auto admitted = admitted_by(model_of(technique, buffers, choice), buffers);
            for (auto& pixel : admitted) pixel = as_stored(*pixel, choice.ao_format);
            const Agreement found =
                agreement_of(admitted, frame.read_floats(Target::kAccessibility), buffers.width,
                             option.name + ' ' + word);
            EXPECT_EQ(found.off, 0U)
                << found.worst.where << ": defined " << found.worst.definition << ", measured "
                << found.worst.measured << ", allowed " << found.worst.allowed;
            for (const float value : frame.read_accessibility()) {
                ASSERT_TRUE(value >= 0.0F && value <= 1.0F) << option.name << ' ' << word;
            }
        }
    }
}

std::vector<std::string> names_of_those_with_a_model() {
    std::vector<std::string> names;
    for (const Technique& technique : techniques()) {
        if (technique.model) names.push_back(technique.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, Computing, testing::ValuesIn(names_of_those_with_a_model()),
                         [](const auto& tested) { return tested.param; });

TEST_F(Techniques, RaymarchFindsAnOccluderThatBlizzardStepsOver) {
    // A thin rail close before a wall: few full-length samples end on it, steps on the way do.
    Scene scene = facing_wall(5.0F);
    tests::add_box(scene, {-3.0F, -0.03F, -4.75F}, {3.0F, 0.03F, -4.7F});
    double mean[2] = {0.0, 0.0};
    int index = 0;
    for (const char* name : {"blizzard", "raymarch"}) {
        Variant choice = choice_of(name);
        choice.samples = 64;
        choice.parameters = {{"radius_m", 0.6}, {"power", 16.0}};
        const std::vector<float> values = middle(render(scene, choice, 256, 256), 40);
        for (const float value : values) mean[index] += value / static_cast<double>(values.size());
        ++index;
    }
    EXPECT_LT(mean[1], mean[0] - 0.02);
}

TEST_F(Techniques, AnyPowerAndAnyLensShiftAreAsDefined) {
    // Powers of 2 are squared, others are left to pow(); the frustum may lie off its centre.
    Scene scene = facing_wall(5.0F);
    tests::add_quad(scene, {-0.5F, -0.6F, -4.8F}, {1.0F, 0.0F, 0.3F}, {0.1F, 1.0F, -0.2F});
    for (const std::string technique : {"blizzard", "raymarch"}) {
        for (const double power : {0.0, 0.5, 1.0, 2.0, 3.0, 16.0, 17.5, 256.0, 512.0}) {
            for (const float shift : {0.0F, 0.4F}) {
                Variant choice = choice_of(technique);
                choice.parameters = {{"power", power}, {"full_threshold_m", 0.0}};
                Camera camera = forward_camera();
                camera.lens_shift = {shift, -0.5F * shift};
                const Frame frame = render(scene, choice, 64, 48, camera);
                const SeenBuffers buffers = seen_buffers(frame, camera);
                const Model& model = find_technique(technique)->model;
                const Agreement agreement =
                    agreement_of(admitted_by(model(buffers, choice), buffers),
                                 frame.read_floats(Target::kAccessibility), 64, technique);
                EXPECT_EQ(agreement.off, 0U) << technique << ", power " << power << ", shift "
                                             << shift << ": " << agreement.worst.where;
                EXPECT_LT(agreement.uncertain, agreement.pixels / 10);
            }
        }
    }
}

}  // namespace
}  // namespace obscura::renderer
