// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/gl/context.h"
#include "renderer/hard_cases/bench.h"
#include "renderer/passes/shared_constants.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

using testing::HasSubstr;
using tests::choice_of;

constexpr int kStoodWidth = 75;
constexpr int kStoodHeight = 51;

/// A floor and a wall that meet, and a box between.
Scene lit_corner() {
    Scene scene = tests::facing_wall(6.0F);
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -40.0F});
    tests::add_box(scene, {-1.5F, -1.0F, -5.5F}, {-0.3F, 0.2F, -4.4F});
    return scene;
}

class Positions : public testing::Test {
  protected:
    Frame render(const Scene& scene, const Variant& choice,
                 const Camera& camera = tests::forward_camera()) {
        const GpuScene gpu(scene);
        const Lighting lighting;
        return renderer_.render({gpu, lighting, camera}, choice, kStoodWidth, kStoodHeight);
    }

    HeadlessContext context_;
    Renderer renderer_;
};

TEST_F(Positions, RebuiltEitherWayOrStoredTheyGiveTheSameAccessibility) {
    for (const std::string technique : {"blizzard", "raymarch", "starcraft2", "hemisphere", "hbao",
                                        "alchemy", "gtao", "bitmask", "layered"}) {
        Variant choice = choice_of(technique);
        const std::vector<float> wanted = render(lit_corner(), choice).read_accessibility();
        for (const std::string position : {"inverse-projection", "stored"}) {
            choice.position = position;
            const std::vector<float> found = render(lit_corner(), choice).read_accessibility();
            int apart = 0;
            double squares = 0.0;
            for (std::size_t i = 0; i < found.size(); ++i) {
                const double off = std::abs(static_cast<double>(found[i] - wanted[i]));
                if (off > 1.0e-4) ++apart;
                squares += off * off;
            }
            // A sample that rounding moves over a texel's border may find another surface.
            EXPECT_LT(apart, kStoodWidth * kStoodHeight / 50) << technique << ", " << position;
            EXPECT_LT(std::sqrt(squares / (kStoodWidth * kStoodHeight)), 0.003)
                << technique << ", " << position;
        }
    }
}

TEST_F(Positions, StoredOnesAreTheSurfacesPointsToTheBitsOfTheirFormat) {
    Camera camera = tests::forward_camera();
    camera.lens_shift = {0.2F, -0.1F};
    for (const auto& [format, bits] : {std::pair("r32f", 19), {"r16f", 10}, {"d24", 19}}) {
        Variant choice = choice_of("blizzard");
        choice.position = "stored";
        choice.depth_format = format;
        const Frame frame = render(lit_corner(), choice, camera);
        SeenBuffers buffers = seen_buffers(frame, camera);
        ASSERT_EQ(buffers.position_m.size(), 3U * kStoodWidth * kStoodHeight);
        EXPECT_EQ(frame.plan().find(frame.plan().seen_by_technique(Target::kPosition))->format,
                  std::string(format) == "r16f" ? "rgba16f" : "rgba32f");
        const SeenView stored(buffers);
        // Against the rays in double precision and the depth in all its bits.
        const Frame exact = render(lit_corner(), choice_of("blizzard"), camera);
        const SeenBuffers rebuilt = seen_buffers(exact, camera);
        const SeenView view(rebuilt);
        double most = 0.0;
        for (int y = 0; y < kStoodHeight; ++y) {
            for (int x = 0; x < kStoodWidth; ++x) {
                if (rebuilt.is_empty(x, y)) continue;
                const Rounded3 a = stored.point(x, y);
                const Rounded3 b = view.point(x, y);
                const double off =
                    std::max({std::abs(a.x.value - b.x.value), std::abs(a.y.value - b.y.value),
                              std::abs(a.z.value - b.z.value)});
                most = std::max(most, off / -b.z.value);
            }
        }
        EXPECT_LT(most, std::ldexp(1.0, -bits)) << format;
    }
}

TEST_F(Positions, ThroughTheInverseOfTheProjectionTheyStayWithinItsRounding) {
    // The model's bound is what every pixel is held against elsewhere; here it must stay small.
    Variant choice = choice_of("blizzard");
    choice.position = "inverse-projection";
    const Frame frame = render(lit_corner(), choice);
    const SeenBuffers buffers = seen_buffers(frame, tests::forward_camera());
    const SeenView view(buffers);
    for (int x = 0; x < kStoodWidth; ++x) {
        const Rounded3 p = view.point(x, kStoodHeight / 3);
        EXPECT_LT(p.x.error, 1.0e-5 * -p.z.value);
        EXPECT_LT(p.z.error, 1.0e-5 * -p.z.value);
    }
}

TEST(PositionVariant, IsRefusedWhereATechniqueHasNoPoints) {
    const auto message = [](const std::string& technique) {
        Variant choice = choice_of(technique);
        choice.position = "stored";
        const auto problems = problems_of(choice);
        return problems.size() == 1 ? problems[0].key + ": " + problems[0].message : "";
    };
    EXPECT_EQ(message("alchemy"), "");
    EXPECT_THAT(message("crytek"), HasSubstr("position: \"stored\" is not allowed: crytek works "
                                             "in the image"));
    EXPECT_THAT(message("homebrewed"), HasSubstr("works in the image"));
    EXPECT_THAT(message("raytraced"), HasSubstr("starts its rays from the depth"));
    EXPECT_THAT(message("none"), HasSubstr("has no buffer of accessibility"));
}

}  // namespace
}  // namespace obscura::renderer
