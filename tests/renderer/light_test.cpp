// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/random.h"
#include "renderer/gl/context.h"
#include "renderer/images/images.h"
#include "renderer/light/environment.h"
#include "renderer/light/shadow.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

TEST(Environment, ALookUpFindsTheTexelThatTheDirectionCameFrom) {
    Environment environment{"numbered", 16, 8, {}};
    for (int i = 0; i < 16 * 8; ++i) environment.radiance.emplace_back(static_cast<float>(i));
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 16; ++column) {
            const glm::vec3 found =
                environment.look_up(direction_of_texel(environment, column, row));
            EXPECT_EQ(found.x, static_cast<float>(16 * row + column));
        }
    }
}

/// Writes the image under that name, in the format that its ending asks for.
void write_image(const std::filesystem::path& file, int width, int height,
                 const std::vector<glm::vec3>& pixels) {
    std::string why;
    ASSERT_TRUE(
        images::library().write(file, {width, height, {"R", "G", "B"}, &pixels.data()->x, {}}, why))
        << why;
}

TEST(Environment, AnEquirectangularImageIsReadAsItIs) {
    const tests::TemporaryFolder folder;
    std::vector<glm::vec3> pixels(32 * 16, glm::vec3(0.5F, 1.0F, 2.0F));
    pixels[0] = {4.0F, 0.25F, 0.0F};
    for (const char* name : {"sky.hdr", "sky.exr"}) {
        write_image(folder.path() / name, 32, 16, pixels);
        const Environment read = load_environment(folder.path() / name);
        EXPECT_EQ(read.width, 32);
        EXPECT_EQ(read.height, 16);
        EXPECT_EQ(read.radiance, pixels) << name;  // powers of two: exact in both formats
    }
}

TEST(Environment, WhatIsNoEnvironmentIsRefusedWithItsName) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder.path() / "text.hdr", "no image");
    EXPECT_THROW((void)load_environment(folder.path() / "text.hdr"), base::Error);
    EXPECT_THROW((void)load_environment(folder.path() / "missing.exr"), base::Error);
    std::vector<glm::vec3> pixels(4 * 2, glm::vec3(std::nanf("")));
    write_image(folder.path() / "nan.exr", 4, 2, pixels);
    try {
        (void)load_environment(folder.path() / "nan.exr");
        FAIL() << "accepted";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        EXPECT_NE(std::string(error.what()).find("nan.exr"), std::string::npos);
    }
}

TEST(Irradiance, OfAnEvenEnvironmentIsItsRadianceOnEveryNormal) {
    const Environment environment{"even", 512, 256,
                                  std::vector<glm::vec3>(512 * 256, {2.0F, 1.0F, 0.5F})};
    const IrradianceSh sh = project_irradiance(environment);
    for (const glm::vec3 normal :
         {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(0.6F, 0, 0.8F)}) {
        EXPECT_NEAR(evaluate_irradiance(sh, normal).x, 2.0F, 1e-4F);
        EXPECT_NEAR(evaluate_irradiance(sh, normal).z, 0.5F, 1e-4F);
    }
}

TEST(Irradiance, OfTheProceduralSkyIsWithinThreePercentOfTheIntegral) {
    const Environment sky = make_sky({}, 128);
    const IrradianceSh sh = project_irradiance(sky);
    base::Random random(3);
    for (int i = 0; i < 20; ++i) {
        const auto z = static_cast<float>(random.uniform(-1.0, 1.0));
        const auto phi = static_cast<float>(random.uniform(0.0, 2.0 * std::numbers::pi));
        const glm::vec3 normal(std::sqrt(1 - z * z) * std::cos(phi), z,
                               std::sqrt(1 - z * z) * std::sin(phi));
        glm::dvec3 sum(0.0);
        for (int row = 0; row < sky.height; ++row) {
            const double solid_angle = 2.0 * std::numbers::pi / sky.width *
                                       (std::cos(std::numbers::pi * row / sky.height) -
                                        std::cos(std::numbers::pi * (row + 1) / sky.height));
            for (int column = 0; column < sky.width; ++column) {
                const double cosine = glm::dot(normal, direction_of_texel(sky, column, row));
                if (cosine <= 0.0) continue;
                sum +=
                    glm::dvec3(sky.radiance[static_cast<std::size_t>(row) * sky.width + column]) *
                    (cosine * solid_angle / std::numbers::pi);
            }
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(evaluate_irradiance(sh, normal)[c], sum[c], 0.03 * sum[c]);
        }
    }
}

TEST(Shadow, TheLightsViewHoldsEveryCornerOfTheScene) {
    const Bounds bounds{{-3.0F, 0.0F, -8.0F}, {5.0F, 4.0F, 1.0F}};
    for (const glm::vec3 towards :
         {glm::vec3(0, 1, 0), glm::vec3(1, 2, 0.5F), glm::vec3(-1, 0.1F, 0)}) {
        const ShadowView view = shadow_view(bounds, {towards, glm::vec3(1.0F)}, 1024);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec4 world((corner & 1) != 0 ? bounds.high_m.x : bounds.low_m.x,
                                  (corner & 2) != 0 ? bounds.high_m.y : bounds.low_m.y,
                                  (corner & 4) != 0 ? bounds.high_m.z : bounds.low_m.z, 1.0F);
            const glm::vec4 at = view.shadow_from_world * world;
            for (int i = 0; i < 3; ++i) {
                EXPECT_GE(at[i], 0.0F);
                EXPECT_LE(at[i], 1.0F);
            }
        }
    }
}

class Light : public testing::Test {
  protected:
    Frame render(const Scene& scene, const Lighting& lighting, const Camera& camera, int width,
                 int height) {
        const GpuScene gpu(scene);
        return renderer_.render({gpu, lighting, camera}, {}, width, height);
    }
    HeadlessContext context_;
    Renderer renderer_;
};

/// Looks down at the ground from 4 m above.
Camera downward_camera() {
    Camera camera = tests::forward_camera();
    camera.position_m = {0.0F, 4.0F, 0.0F};
    camera.target_m = glm::vec3(0.0F);
    camera.up = {0.0F, 0.0F, -1.0F};
    return camera;
}

TEST_F(Light, ConstantAmbientLightShowsTheAlbedoOnTheBackgroundColour) {
    Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.5F);
    tests::add_quad(scene, {0.0F, -50.0F, -5.0F}, {50.0F, 0.0F, 0.0F}, {0.0F, 100.0F, 0.0F});
    const Frame frame = render(scene, {}, tests::forward_camera(), 64, 64);
    const std::vector<std::uint8_t> image = frame.read_display();
    EXPECT_EQ(image[3 * (32 * 64 + 10)], 255);       // the background is white
    EXPECT_NEAR(image[3 * (32 * 64 + 50)], 188, 1);  // linear 0.5 is sRGB 188
}

TEST_F(Light, TheUpperRowOfTheImageIsTheUpperPartOfTheScene) {
    Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.0F);
    tests::add_quad(scene, {-50.0F, 0.0F, -5.0F}, {100.0F, 0.0F, 0.0F}, {0.0F, 50.0F, 0.0F});
    const std::vector<std::uint8_t> image =
        render(scene, {}, tests::forward_camera(), 8, 8).read_display();
    EXPECT_EQ(image.front(), 0);
    EXPECT_EQ(image.back(), 255);
}

TEST_F(Light, AFlatGroundUnderSlantingSunHasNoAcneAndABoxShadowStartsAtItsFoot) {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-10.0F, 0.0F, 10.0F}, {20.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -20.0F});
    tests::add_box(scene, {-1.0F, 0.0F, -0.5F}, {-0.5F, 0.5F, 0.5F});
    for (const float slope : {0.2F, 0.4F, 1.0F, 3.0F}) {
        Lighting lighting;
        lighting.ambient = glm::vec3(0.0F);
        lighting.lights.push_back(
            {glm::normalize(glm::vec3(-1.0F, slope, 0.0F)), glm::vec3(std::numbers::pi_v<float>)});
        const Frame frame = render(scene, lighting, downward_camera(), 400, 400);
        const std::vector<std::uint8_t> image = frame.read_display();
        const auto at = [&image](double x_m, double z_m) {
            // 4 m above, 60 degrees high: the image spans 2 * 4 tan 30 = 4.6188 m.
            const int column = static_cast<int>(200.0 + x_m / 4.6188 * 400.0);
            const int row = static_cast<int>(200.0 + z_m / 4.6188 * 400.0);
            return static_cast<int>(image[3 * (static_cast<std::size_t>(row) * 400 + column)]);
        };
        const int lit = at(-2.0, -1.5);
        EXPECT_GT(lit, 60) << slope;
        for (double x = -2.2; x < 2.2; x += 0.05) {
            EXPECT_NEAR(at(x, -1.5), lit, 1) << "acne at " << x << ", slope " << slope;
        }
        // Behind the box, as near to its foot as three texels allow, there is shadow.
        EXPECT_LT(at(-0.5 + 0.06, 0.0), lit / 4) << slope;
        EXPECT_LT(at(-0.5 + 0.5 * 0.5 / slope, 0.0), lit / 4) << slope;
        EXPECT_NEAR(at(-0.5 + 0.5 / slope + 0.1, 0.0), lit, 2) << slope;
    }
}

TEST_F(Light, AccessibilityScalesTheAmbientTermAndNothingElse) {
    // A wall that faces camera and light: crytek's accessibility is 0.75 there.
    const Scene scene = tests::facing_wall(5.0F);
    Lighting lighting;
    lighting.ambient = glm::vec3(0.25F);
    lighting.lights.push_back(
        {glm::vec3(0.0F, 0.0F, 1.0F), glm::vec3(0.4F * std::numbers::pi_v<float>)});
    const auto middle = [&](const Variant& choice) {
        const GpuScene gpu(scene);
        const Frame frame =
            renderer_.render({gpu, lighting, tests::forward_camera()}, choice, 256, 256);
        return static_cast<int>(frame.read_display()[3 * (128 * 256 + 128)]);
    };
    const auto srgb = [](double linear) {
        return 255.0 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055);
    };
    EXPECT_NEAR(middle({}), srgb(0.25 + 0.4), 1.0);
    EXPECT_NEAR(middle({"crytek", 24, {}, "none"}), srgb(0.75 * 0.25 + 0.4), 1.0);
}

TEST_F(Light, TheSkyIsSeenWhereItIs) {
    const auto environment = std::make_shared<Environment>();
    environment->width = 64;
    environment->height = 32;
    environment->radiance.assign(64 * 32, glm::vec3(0.0F));
    // Bright above the horizon, straight ahead (-Z) brighter in red.
    for (int row = 0; row < 16; ++row) {
        for (int column = 0; column < 64; ++column) {
            environment->radiance[static_cast<std::size_t>(row) * 64 + column] = {
                column < 8 || column >= 56 ? 1.0F : 0.0F, 0.25F, 0.25F};
        }
    }
    Lighting lighting;
    lighting.environment = environment;
    const std::vector<std::uint8_t> image =
        render(tests::empty_scene(), lighting, tests::forward_camera(), 64, 64).read_display();
    EXPECT_GT(image[3 * (10 * 64 + 32)], 200);
    EXPECT_LT(image[3 * (54 * 64 + 32)], 20);
}

}  // namespace
}  // namespace obscura::renderer
