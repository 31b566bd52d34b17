// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/reference.h"
#include "renderer/reference/sampler.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

class RaysTest : public testing::Test {
  protected:
    explicit RaysTest(StepsBy steps) : renderer_(steps) {}

    Frame render(const Scene& scene, const Variant& choice, int width = 96, int height = 64) {
        return render(renderer_, scene, choice, width, height);
    }
    Frame render(Renderer& renderer, const Scene& scene, const Variant& choice, int width = 96,
                 int height = 64) {
        const GpuScene gpu(scene);
        const ReferenceScene rays(scene);
        return renderer.render({gpu,
                                lighting_,
                                tests::forward_camera(),
                                {},
                                {},
                                [&rays]() -> const ReferenceScene& { return rays; }},
                               choice, width, height);
    }

    void expect_open_planes();

    static Variant with(int rays, double radius_m, const std::string& denoise = "none") {
        Variant choice = tests::choice_of("raytraced", denoise);
        choice.samples = rays;
        choice.parameters["radius_m"] = radius_m;
        return choice;
    }

    HeadlessContext context_;
    Renderer renderer_;
    Lighting lighting_;
};

/// By Embree on the processor.
class RaysFromBuffers : public RaysTest {
  protected:
    RaysFromBuffers() : RaysTest(StepsBy::kFragments) {}
};

Scene boxes_in_a_corner() {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-20.0F, -1.0F, -7.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 20.0F, 0.0F});
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -7.0F});
    for (int i = 0; i < 5; ++i) {
        const auto x = static_cast<float>(i - 2);
        tests::add_box(scene, {x, -1.0F, -6.0F + 0.3F * x}, {x + 0.6F, 0.3F * x, -5.3F + 0.3F * x});
    }
    return scene;
}

double rmse(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double off = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

std::vector<float> truth_of(const Scene& scene, double radius_m) {
    ReferenceOptions options;
    options.radius_m = radius_m;
    options.rays = 1024;
    return ReferenceScene(scene).trace(tests::forward_camera(), 96, 64, options).accessibility;
}

TEST_F(RaysFromBuffers, MeetTheClosedFormOfACorner) {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-1.0F, -50.0F, -6.0F}, {100.0F, 0.0F, 0.0F}, {0.0F, 100.0F, 0.0F});
    tests::add_quad(scene, {-1.0F, -50.0F, 50.0F}, {0.0F, 0.0F, -56.0F}, {0.0F, 100.0F, 0.0F});
    const Frame frame = render(scene, with(64, 1.5), 128, 128);
    const std::vector<float> open = frame.read_floats(Target::kAccessibility);
    const double half_m = 6.0 * std::tan(std::numbers::pi / 6.0);
    for (int column = 0; column < 128; column += 4) {
        const double c = ((2.0 * (column + 2) / 128 - 1.0) * half_m + 1.0) / 1.5;
        if (c < 0.06) continue;
        double mean = 0.0;
        for (int y = 0; y < 128; ++y) {
            for (int x = column; x < column + 4; ++x)
                mean += open[static_cast<std::size_t>(y * 128 + x)] / 512.0;
        }
        const double expected =
            c >= 1.0 ? 1.0 : 1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / std::numbers::pi;
        EXPECT_NEAR(mean, expected, 0.005) << c;
    }
}

void RaysTest::expect_open_planes() {
    for (const float tilt_rad : {0.0F, 0.8F, 1.4F, 1.53F}) {
        for (const float distance_m : {0.2F, 5.0F, 80.0F}) {
            Scene scene = tests::empty_scene();
            const glm::vec3 up(0.0F, std::cos(tilt_rad), -std::sin(tilt_rad));
            const float half_m = 500.0F * distance_m;
            tests::add_quad(scene, glm::vec3(-half_m, 0.0F, -distance_m) - half_m * up,
                            {2.0F * half_m, 0.0F, 0.0F}, 2.0F * half_m * up);
            for (const float value :
                 render(scene, with(8, 0.2 * distance_m)).read_floats(Target::kAccessibility)) {
                ASSERT_EQ(value, 1.0F) << tilt_rad << " rad, " << distance_m << " m";
            }
        }
    }
}

TEST_F(RaysFromBuffers, LeaveAPlaneOpenAtAnyTiltAndDistance) { expect_open_planes(); }

TEST_F(RaysFromBuffers, ComeNearerToTheTruthWithTheirNumberAndAreTheSameTwice) {
    const Scene scene = boxes_in_a_corner();
    const std::vector<float> truth = truth_of(scene, 1.0);
    double before = 1.0;
    for (const int rays : {1, 4, 16, 64}) {
        const Frame frame = render(scene, with(rays, 1.0));
        const std::vector<float> open = frame.read_floats(Target::kAccessibility);
        EXPECT_LT(rmse(open, truth), 0.6 * before) << rays;
        before = rmse(open, truth);
        EXPECT_EQ(open, render(scene, with(rays, 1.0)).read_floats(Target::kAccessibility));
    }
    EXPECT_LT(before, 0.025);
}

TEST_F(RaysFromBuffers, TheirFilterIsNeverWorseThanNoneAtAnyCount) {
    const Scene scene = boxes_in_a_corner();
    for (const double radius_m : {0.2, 1.0, 4.0}) {
        const std::vector<float> truth = truth_of(scene, radius_m);
        for (const int rays : {1, 2, 3, 4, 8, 16, 32, 64}) {
            const Frame frame = render(scene, with(rays, radius_m, "known_error"));
            EXPECT_LE(rmse(frame.read_floats(Target::kDenoised), truth),
                      rmse(frame.read_floats(Target::kAccessibility), truth))
                << rays << " rays, R " << radius_m;
        }
    }
}

TEST_F(RaysFromBuffers, EmptyPixelsAreOpenAndAnySizeAndRadiusIsSound) {
    Scene scene = tests::empty_scene();
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 1.0F, -4.0F});
    for (const auto& [width, height] : {std::pair(1, 1), {17, 9}, {96, 64}}) {
        for (const double radius_m : {0.0, 1e-8, 0.5, 1e6}) {
            const Frame frame = render(scene, with(3, radius_m), width, height);
            const std::vector<float> depth = frame.read_floats(Target::kDepth);
            const std::vector<float> open = frame.read_floats(Target::kAccessibility);
            for (std::size_t i = 0; i < open.size(); ++i) {
                ASSERT_TRUE(open[i] >= 0.0F && open[i] <= 1.0F);
                if (depth[i] >= kBackgroundLimit_m) {
                    ASSERT_EQ(open[i], 1.0F);
                }
            }
        }
    }
}

TEST_F(RaysFromBuffers, AreRefusedWhereAViewHasNone) {
    const Scene scene = boxes_in_a_corner();
    const GpuScene gpu(scene);
    EXPECT_THROW(
        (void)renderer_.render({gpu, lighting_, tests::forward_camera()}, with(1, 0.5), 8, 8),
        base::Error);
}

class RaysOfAShader : public RaysTest {
  protected:
    RaysOfAShader() : RaysTest(StepsBy::kCompute) {}

    /// The directions are the same ones, so only a ray past an edge may meet another triangle, and
    /// a pixel that an edge runs through show the face on its other side.
    void expect_the_same(const Scene& scene) {
        const std::vector<float> open =
            render(scene, with(4, 1.0)).read_floats(Target::kAccessibility);
        Renderer processor(StepsBy::kFragments);
        const std::vector<float> expected =
            render(processor, scene, with(4, 1.0)).read_floats(Target::kAccessibility);
        std::size_t unlike = 0;
        for (std::size_t i = 0; i < open.size(); ++i) unlike += open[i] != expected[i] ? 1 : 0;
        EXPECT_LE(unlike, open.size() / 1000);
        EXPECT_LT(rmse(open, expected), 0.01);
    }
};

TEST_F(RaysOfAShader, MeetWhatEmbreesMeet) { expect_the_same(boxes_in_a_corner()); }

TEST_F(RaysOfAShader, MeetNoBacksThatAreNotDrawnFromTheCameraButAllFromASurface) {
    Scene scene = boxes_in_a_corner();
    // Between the camera and the boxes, seen from behind: it is not drawn, and it occludes.
    tests::add_quad(scene, {-1.0F, -0.5F, -5.0F}, {0.0F, 1.5F, 0.0F}, {2.0F, 0.0F, 0.0F});
    expect_the_same(scene);
    scene.materials[0].double_sided = true;
    expect_the_same(scene);
}

TEST_F(RaysOfAShader, PassThroughTheHolesOfCutOuts) {
    Scene scene = boxes_in_a_corner();
    Texture texture;
    texture.name = "grid";
    texture.width = 5;  // a number of texels that shares words with the next texture's
    texture.height = 3;
    for (int i = 0; i < 15; ++i) {
        texture.rgba.insert(texture.rgba.end(),
                            {255, 255, 255, static_cast<std::uint8_t>(i % 2 == 0 ? 255 : 0)});
    }
    for (int i = 0; i < 2; ++i) {
        Material holes;
        holes.coverage = Coverage::kCutOut;
        holes.double_sided = true;
        holes.alpha_cutoff = 0.3F + 0.3F * static_cast<float>(i);
        holes.albedo_texture = static_cast<TextureIndex>(scene.textures.size());
        scene.textures.push_back(texture);
        scene.materials.push_back(holes);
        const float x = i == 0 ? -1.8F : 0.4F;
        tests::add_quad(scene, {x, -0.9F, -4.8F}, {1.6F, 0.0F, 0.0F}, {0.0F, 1.6F, -0.4F});
        scene.meshes.back().material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    }
    expect_the_same(scene);
    Scene closed = scene;
    for (Material& material : closed.materials) material.coverage = Coverage::kOpaque;
    EXPECT_NE(render(scene, with(4, 1.0)).read_floats(Target::kAccessibility),
              render(closed, with(4, 1.0)).read_floats(Target::kAccessibility));
}

TEST_F(RaysOfAShader, MeetASceneOfOneTriangle) {
    Scene one = tests::facing_wall(2.0F);
    one.meshes[0].indices.resize(3);
    expect_the_same(one);
}

TEST_F(RaysOfAShader, LeaveAPlaneOpenAtAnyTiltAndDistance) { expect_open_planes(); }

TEST_F(RaysOfAShader, AreOfTheSceneThatIsDrawn) {
    const Scene first = boxes_in_a_corner();
    const auto open = [this](const Scene& scene) {
        return render(scene, with(4, 1.0)).read_floats(Target::kAccessibility);
    };
    const std::vector<float> before = open(first);
    EXPECT_NE(open(tests::facing_wall(2.0F)), before);
    EXPECT_EQ(open(first), before);
}

TEST(BlockSampler, GivesEachPixelAndEachBlockEvenlySpreadDirections) {
    for (const int rays : {1, 2, 4, 16}) {
        const BlockSampler sampler(rays);
        const auto all = static_cast<std::size_t>(16 * rays);
        std::vector<float> x(all), y(all), z(all);
        sampler.directions(7, x.data(), y.data(), z.data());
        double mean_z = 0.0;
        for (std::size_t i = 0; i < all; ++i) {
            EXPECT_NEAR(x[i] * x[i] + y[i] * y[i] + z[i] * z[i], 1.0F, 1e-5F);
            mean_z += z[i] / static_cast<double>(all);
        }
        // The cosine's mean under its own density.
        EXPECT_NEAR(mean_z, 2.0 / 3.0, 0.5 / static_cast<double>(all) + 0.02);
    }
    std::vector<int> parts;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) parts.push_back(BlockSampler::part_of(x, y));
    }
    std::sort(parts.begin(), parts.end());
    for (int i = 0; i < 16; ++i) EXPECT_EQ(parts[static_cast<std::size_t>(i)], i);
}

}  // namespace
}  // namespace obscura::renderer
