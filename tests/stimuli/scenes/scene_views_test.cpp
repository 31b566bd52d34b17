// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "renderer/frame/gpu_scene.h"
#include "renderer/frame/plan.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "stimuli/scenes/list.h"

namespace obscura::stimuli {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 90;

/// Each camera's image has many colours and is neither mostly black nor mostly white. Cards of
/// leaves seen edge on must end, too: with anisotropic filtering a software rasterizer does not.
void expect_full_views(const BuiltinScene& entry, Validity level) {
    const renderer::Scene scene = entry.build();
    const renderer::Lighting light = entry.lighting(level);
    const renderer::HeadlessContext context;
    renderer::Renderer renderer;
    const renderer::GpuScene on_gpu(scene);
    renderer::Variant choice;
    choice.technique = "none";
    for (const renderer::Camera& camera : scene.cameras) {
        const auto image =
            renderer.render({on_gpu, light, camera}, choice, kWidth, kHeight).read_display();
        ASSERT_EQ(image.size(), 3U * kWidth * kHeight);
        std::set<std::tuple<int, int, int>> colours;
        int black = 0;
        int white = 0;
        for (std::size_t i = 0; i < image.size(); i += 3) {
            const std::tuple colour(image[i], image[i + 1], image[i + 2]);
            colours.insert(colour);
            black += colour < std::tuple(8, 8, 8) ? 1 : 0;
            white += colour == std::tuple(255, 255, 255) ? 1 : 0;
        }
        EXPECT_GT(colours.size(), 1500U) << camera.name;
        EXPECT_LT(black, kWidth * kHeight / 20) << camera.name;
        EXPECT_LT(white, kWidth * kHeight / 8) << camera.name;
    }
}

TEST(SceneViews, OfTheMachineAreFull) { expect_full_views(make_machine(), Validity::kModerate); }

TEST(SceneViews, OfTheRoomAreFull) { expect_full_views(make_room(), Validity::kHigh); }

TEST(SceneViews, OfTheGardenAreFull) { expect_full_views(make_garden(), Validity::kHigh); }

}  // namespace
}  // namespace obscura::stimuli
