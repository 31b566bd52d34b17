// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "renderer/frame/gpu_scene.h"
#include "renderer/frame/plan.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "stimuli/scenes/list.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::stimuli {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 90;
constexpr int kBlock = 10;

/// The difference of the brightest and darkest green of a block.
int spread_of_block(const std::vector<std::uint8_t>& rgb, int left, int top) {
    int low = 255;
    int high = 0;
    for (int y = top; y < top + kBlock; ++y) {
        for (int x = left; x < left + kBlock; ++x) {
            const int green = rgb[static_cast<std::size_t>(3 * (y * kWidth + x) + 1)];
            low = std::min(low, green);
            high = std::max(high, green);
        }
    }
    return high - low;
}

/// Each camera sees something nearly everywhere, and its image is neither mostly black nor mostly
/// white: a camera that looks at a bare wall, out of the scene or from inside a thing fails. Cards
/// of leaves seen edge on must end, too: with anisotropic filtering a software rasterizer does not.
void expect_full_views(const BuiltinScene& entry, Validity level) {
    const OpenedScene opened = open_scene(entry.id, {}, {}, {entry});
    const renderer::Scene& scene = *opened.scene;
    const renderer::Lighting light = opened.with_probes(opened.lighting(level));
    const renderer::HeadlessContext context;
    renderer::Renderer renderer;
    const renderer::GpuScene on_gpu(scene);
    renderer::Variant choice;
    choice.technique = "none";
    for (const renderer::Camera& camera : scene.cameras) {
        const auto image =
            renderer.render({on_gpu, light, camera}, choice, kWidth, kHeight).read_display();
        ASSERT_EQ(image.size(), 3U * kWidth * kHeight);
        int varied = 0;
        for (int top = 0; top < kHeight; top += kBlock) {
            for (int left = 0; left < kWidth; left += kBlock) {
                varied += spread_of_block(image, left, top) >= 10 ? 1 : 0;
            }
        }
        int black = 0;
        int white = 0;
        for (std::size_t i = 0; i < image.size(); i += 3) {
            const std::tuple colour(image[i], image[i + 1], image[i + 2]);
            black += colour < std::tuple(8, 8, 8) ? 1 : 0;
            white += colour == std::tuple(255, 255, 255) ? 1 : 0;
        }
        EXPECT_GT(varied, kWidth * kHeight / (kBlock * kBlock) / 2) << camera.name;
        EXPECT_LT(black, kWidth * kHeight / 20) << camera.name;
        EXPECT_LT(white, kWidth * kHeight / 8) << camera.name;
    }
}

TEST(SceneViews, OfTheMachineAreFull) { expect_full_views(make_machine(), Validity::kModerate); }

TEST(SceneViews, OfTheRoomAreFull) { expect_full_views(make_room(), Validity::kHigh); }

TEST(SceneViews, OfTheGardenAreFull) { expect_full_views(make_garden(), Validity::kHigh); }

}  // namespace
}  // namespace obscura::stimuli
