// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "renderer/reference/irradiance_baker.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

/// A box on a floor under a sky, before walls that close two sides of it.
class ProbesOnGpu : public testing::Test {
  protected:
    ProbesOnGpu() {
        scene_.materials[0].albedo = glm::vec3(0.5F);
        tests::add_quad(scene_, {-3.0F, -1.0F, 0.0F}, {6.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -8.0F});
        tests::add_quad(scene_, {-3.0F, -1.0F, -8.0F}, {6.0F, 0.0F, 0.0F}, {0.0F, 4.0F, 0.0F});
        tests::add_quad(scene_, {-3.0F, -1.0F, 0.0F}, {0.0F, 0.0F, -8.0F}, {0.0F, 4.0F, 0.0F});
        tests::add_box(scene_, {-1.0F, -1.0F, -6.0F}, {0.5F, 0.5F, -4.0F});
        light_.environment = std::make_shared<Environment>(make_sky({}, 64));
        light_.irradiance_probes = true;
    }

    void bake() {
        light_.irradiance_grid = IrradianceBaker(std::make_shared<Scene>(scene_)).bake(light_);
    }

    Frame render(const FrameOptions& options = {}, const Variant& variant = {}) {
        const GpuScene gpu(scene_);
        return renderer_.render({gpu, light_, camera_, options}, variant, kWidth, kHeight);
    }

    static constexpr int kWidth = 96;
    static constexpr int kHeight = 64;
    HeadlessContext context_;
    Renderer renderer_;
    Scene scene_ = tests::empty_scene();
    Lighting light_;
    Camera camera_ = tests::forward_camera();
};

TEST_F(ProbesOnGpu, GiveEverySurfaceWhatTheyHaveWhereItStands) {
    bake();
    FrameOptions options;
    options.all_buffers = true;
    const Frame frame = render(options);
    const std::vector<float> ambient = frame.read_components(Target::kAmbient, 3);
    const std::vector<float> code = frame.read_components(Target::kNormal, 3);
    const std::vector<float> depth_m = frame.read_floats(Target::kDepth);
    const CameraMatrices camera = matrices_of(camera_, kWidth, kHeight);
    int seen = 0;
    float least = 10.0F;
    float most = 0.0F;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto i = static_cast<std::size_t>(y * kWidth + x);
            if (depth_m[i] > 100.0F) continue;
            const glm::vec2 uv((static_cast<float>(x) + 0.5F) / kWidth,
                               1.0F - (static_cast<float>(y) + 0.5F) / kHeight);
            const glm::vec3 point =
                glm::vec3((uv * 2.0F - 1.0F) * camera.ray_scale, -1.0F) * depth_m[i];
            const glm::vec3 normal = glm::normalize(
                glm::vec3(code[3 * i], code[3 * i + 1], code[3 * i + 2]) * (255.0F / 127.0F) -
                128.0F / 127.0F);
            const glm::vec3 expected = light_.irradiance_grid->look_up(point, normal);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(ambient[3 * i + c], expected[static_cast<int>(c)], 4e-3F)
                    << x << ' ' << y;
            }
            ++seen;
            least = std::min(least, expected.y);
            most = std::max(most, expected.y);
        }
    }
    EXPECT_GT(seen, kWidth * kHeight / 2);
    EXPECT_GT(most, 1.5F * least);  // it does depend on the place
}

TEST_F(ProbesOnGpu, LightSurfacesAlikeFromABufferAndWhileTheyAreDrawn) {
    bake();
    const std::vector<std::uint8_t> deferred = render().read_display();
    Variant forward;
    forward.pipeline = "nd-buffer";
    const std::vector<std::uint8_t> drawn = render({}, forward).read_display();
    int apart = 0;
    for (std::size_t i = 0; i < deferred.size(); ++i) {
        apart += std::abs(deferred[i] - drawn[i]) > 2 ? 1 : 0;
    }
    EXPECT_EQ(apart, 0);
}

TEST_F(ProbesOnGpu, ChangeNoAccessibility) {
    const Variant variant = tests::choice_of("blizzard");
    light_.irradiance_probes = false;
    const std::vector<float> without = render({}, variant).read_accessibility();
    light_.irradiance_probes = true;
    bake();
    EXPECT_EQ(render({}, variant).read_accessibility(), without);
}

TEST_F(ProbesOnGpu, ThatWereAskedForAndNotBakedAreNoImage) {
    EXPECT_THROW((void)render(), base::Error);
}

}  // namespace
}  // namespace obscura::renderer
