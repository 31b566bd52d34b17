// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/irradiance_baker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/frame/plan.h"
#include "renderer/light/irradiance_parts.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

/// What rounding to half floats leaves of a value near 1, times the nine coefficients.
constexpr float kRounding = 2e-3F;
constexpr glm::vec3 kUp(0.0F, 1.0F, 0.0F);

Lighting even_light(const glm::vec3& radiance = glm::vec3(1.0F)) {
    auto environment = std::make_shared<Environment>();
    environment->name = "even";
    environment->width = 8;
    environment->height = 4;
    environment->radiance.assign(32, radiance);
    Lighting light;
    light.environment = environment;
    light.irradiance_probes = true;
    return light;
}

std::shared_ptr<const IrradianceGrid> baked(const Scene& scene, const Lighting& light,
                                            const ProbeOptions& options = {}) {
    return IrradianceBaker(std::make_shared<Scene>(scene), options).bake(light);
}

/// Faces that look inwards, but for those whose number (-x +x -y +y -z +z) is left out.
void add_room(Scene& scene, const glm::vec3& low, const glm::vec3& high, int without = -1) {
    const glm::vec3 x(high.x - low.x, 0.0F, 0.0F);
    const glm::vec3 y(0.0F, high.y - low.y, 0.0F);
    const glm::vec3 z(0.0F, 0.0F, high.z - low.z);
    if (without != 0) tests::add_quad(scene, low, y, z);
    if (without != 1) tests::add_quad(scene, low + x, z, y);
    if (without != 2) tests::add_quad(scene, low, z, x);
    if (without != 3) tests::add_quad(scene, low + y, x, z);
    if (without != 4) tests::add_quad(scene, low, x, y);
    if (without != 5) tests::add_quad(scene, low + z, y, x);
}

TEST(IrradianceParts, OfAllDirectionsAreTheEnvironmentsIrradiance) {
    const Environment sky = make_sky({}, 128);
    const DirectionCells cells(10);
    IrradianceSh sum{};
    for (const IrradiancePart& part : irradiance_parts(sky, cells)) {
        for (std::size_t i = 0; i < 9; ++i) sum[i] += part.of_environment[i];
    }
    const IrradianceSh whole = project_irradiance(sky);
    for (const glm::vec3 normal :
         {kUp, glm::vec3(0.6F, 0.0F, 0.8F), glm::vec3(0.0F, -1.0F, 0.0F)}) {
        EXPECT_NEAR(evaluate_irradiance(sum, normal).y, evaluate_irradiance(whole, normal).y,
                    3e-3F);
    }
    for (int stratum = 0; stratum < DirectionCells::kStrata; ++stratum) {
        for (const glm::vec3& way : cells.ways(stratum)) EXPECT_NEAR(glm::length(way), 1.0F, 1e-6F);
    }
}

TEST(Probes, StandInBoxesAboutAsWideAsHighAndNoMoreThanAreAllowed) {
    for (const glm::vec3 size : {glm::vec3(16.0F, 12.0F, 24.0F), glm::vec3(1.0F, 0.0F, 1.0F),
                                 glm::vec3(5000.0F, 1.0F, 1.0F)}) {
        const ProbeLattice lattice = probes_over({glm::vec3(-1.0F), size - 1.0F}, 3000);
        EXPECT_LE(lattice.probes(), 3000U);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(lattice.count[axis], 1);
            EXPECT_LE(lattice.count[axis], kMostProbesAlong);
            EXPECT_GT(lattice.step_m[axis], 0.0F);
        }
    }
    const ProbeLattice lattice = probes_over({glm::vec3(0.0F), {16.0F, 12.0F, 24.0F}}, 3000);
    EXPECT_GT(lattice.probes(), 2000U);
    EXPECT_NEAR(lattice.step_m.x / lattice.step_m.y, 1.0F, 0.15F);
    EXPECT_NEAR(lattice.first_m.x, 0.5F * lattice.step_m.x, 1e-4F);
    EXPECT_NEAR(lattice.position_m(lattice.count - 1).z, 24.0F - 0.5F * lattice.step_m.z, 1e-4F);
}

TEST(Probes, OverAnOpenPlaneHaveTheIrradianceOfAnEvenEnvironment) {
    Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.3F);
    // So wide that rays half a degree below the horizon still meet it.
    tests::add_quad(scene, {-4e3F, 0.0F, 4e3F}, {8e3F, 0.0F, 0.0F}, {0.0F, 0.0F, -8e3F});
    tests::add_quad(scene, {-0.1F, 2.0F, 0.1F}, {0.2F, 0.0F, 0.0F}, {0.0F, 0.0F, -0.2F});
    const auto grid = baked(scene, even_light({1.0F, 0.5F, 2.0F}));
    for (const float x : {-2000.0F, -3.0F, 7.0F, 2500.0F}) {
        const glm::vec3 found = grid->look_up({x, 0.0F, 11.0F}, kUp);
        EXPECT_NEAR(found.x, 1.0F, kRounding);
        EXPECT_NEAR(found.y, 0.5F, kRounding);
        EXPECT_NEAR(found.z, 2.0F, 2.0F * kRounding);
    }
}

TEST(Probes, InAClosedBoxAreDarkWhateverIsOutside) {
    Scene scene = tests::empty_scene();
    add_room(scene, glm::vec3(-1.0F), glm::vec3(1.0F));
    const auto grid = baked(scene, even_light(glm::vec3(100.0F)), {.most_probes = 200});
    for (const Probe& probe : grid->probes) {
        for (const glm::vec3& value : probe.weighted) EXPECT_EQ(value, glm::vec3(0.0F));
    }
}

TEST(Probes, BesideACornerOfADarkRoomDoNotLightItFromOutside) {
    Scene scene = tests::empty_scene();
    add_room(scene, glm::vec3(0.0F), glm::vec3(4.0F, 3.0F, 5.0F));
    // Far things, so that probes stand around the room.
    tests::add_quad(scene, {-4.0F, -3.0F, -4.0F}, {0.0F, 0.0F, 0.1F}, {0.1F, 0.0F, 0.0F});
    tests::add_quad(scene, {8.0F, 6.0F, 9.0F}, {0.0F, 0.0F, 0.1F}, {0.1F, 0.0F, 0.0F});
    const auto grid = baked(scene, even_light(), {.most_probes = 2500});
    float most = 0.0F;
    for (const float x : {0.01F, 0.3F, 2.0F, 3.7F, 3.99F}) {
        for (const float y : {0.01F, 0.3F, 1.5F, 2.7F, 2.99F}) {
            for (const float z : {0.01F, 0.3F, 2.5F, 4.7F, 4.99F}) {
                const glm::vec3 at(x, y, z);
                if (z == 0.01F) most = std::max(most, grid->look_up(at, {0, 0, 1}).y);
                if (z == 4.99F) most = std::max(most, grid->look_up(at, {0, 0, -1}).y);
                if (x == 0.01F) most = std::max(most, grid->look_up(at, {1, 0, 0}).y);
                if (x == 3.99F) most = std::max(most, grid->look_up(at, {-1, 0, 0}).y);
                if (y == 0.01F) most = std::max(most, grid->look_up(at, kUp).y);
                if (y == 2.99F) most = std::max(most, grid->look_up(at, -kUp).y);
            }
        }
    }
    EXPECT_LT(most, 3e-3F) << "of an environment of 1 outside";
}

TEST(Probes, InAClosedBoxWhoseWallsSendOutLightHaveThatOfAFurnace) {
    // The sum of the geometric series: what a wall sends out over one less its albedo.
    Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.5F);
    scene.materials[0].emissive = glm::vec3(1.0F, 0.2F, 0.0F);
    add_room(scene, glm::vec3(-1.0F), glm::vec3(1.0F));
    const auto grid = baked(scene, even_light(), {.most_probes = 64, .bounces = 16});
    const glm::vec3 found = grid->look_up({0.3F, -1.0F, 0.2F}, kUp);
    EXPECT_NEAR(found.x, 2.0F, 3.0F * kRounding);
    EXPECT_NEAR(found.y, 0.4F, kRounding);
    EXPECT_EQ(found.z, 0.0F);
}

TEST(Probes, GainByEveryBounceInAWhiteBoxThatIsOpenAtOneSideAndNeverReachTheEnvironment) {
    Scene scene = tests::empty_scene();
    add_room(scene, glm::vec3(-1.0F), glm::vec3(1.0F), 5);
    float before = 0.0F;
    for (const int bounces : {0, 1, 2, 4, 16, 40}) {
        const auto grid = baked(scene, even_light(), {.most_probes = 200, .bounces = bounces});
        const float found = grid->look_up({0.0F, -1.0F, -0.5F}, kUp).x;
        EXPECT_GT(found, before * 1.0001F) << bounces;
        EXPECT_LT(found, 1.0F + kRounding) << bounces;
        before = found;
    }
    // Nothing is absorbed, so in the end it is as bright as outside.
    EXPECT_GT(before, 0.9F);
}

TEST(Probes, AreDarkerAtTheClosedEndOfACorridorThanAtItsMouth) {
    Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.5F);
    add_room(scene, {-1.0F, 0.0F, -12.0F}, {1.0F, 2.0F, 0.0F}, 5);
    const auto grid = baked(scene, even_light());
    float before = 1.0F;
    for (const float z : {-0.5F, -2.0F, -4.0F, -7.0F, -11.5F}) {
        const float found = grid->look_up({0.0F, 0.0F, z}, kUp).x;
        EXPECT_LT(found, before) << z;
        before = found;
    }
    EXPECT_LT(before, 0.05F);
}

TEST(Probes, HaveTheSunsLightThatAWallReflectsAndNotTheSunsOwn) {
    Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-40.0F, 0.0F, 40.0F}, {80.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -80.0F});
    Lighting light = even_light(glm::vec3(0.0F));
    light.lights.push_back({kUp, glm::vec3(std::numbers::pi_v<float>)});
    const auto grid = baked(scene, light, {.most_probes = 100, .bounces = 0});
    // White ground under a sun that makes it 1: a ceiling above it has 1, the ground itself 0.
    EXPECT_NEAR(grid->look_up({0.0F, 1.0F, 0.0F}, -kUp).x, 1.0F, 2.0F * kRounding);
    EXPECT_NEAR(grid->look_up({0.0F, 0.0F, 0.0F}, kUp).x, 0.0F, kRounding);
    light.lights[0].towards_light = -kUp;  // from below: the ground's own side is in shadow
    EXPECT_EQ(baked(scene, light, {.most_probes = 100, .bounces = 0})
                  ->look_up({0.0F, 1.0F, 0.0F}, -kUp)
                  .x,
              0.0F);
}

TEST(Probes, WithinAThickWallLeakLessThanThreeThousandthsIntoADarkRoom) {
    // A dark room within a solid whose walls are thicker than the steps, under a bright sky.
    Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.5F);
    tests::add_box(scene, glm::vec3(-3.0F), glm::vec3(3.0F));
    add_room(scene, glm::vec3(-1.5F), glm::vec3(1.5F));
    tests::add_quad(scene, {-6.0F, -3.0F, 6.0F}, {12.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -12.0F});
    tests::add_quad(scene, {-0.1F, 6.0F, 0.1F}, {0.2F, 0.0F, 0.0F}, {0.0F, 0.0F, -0.2F});
    const auto grid = baked(scene, even_light(glm::vec3(10.0F)));
    ASSERT_LT(grid->lattice.step_m.x, 1.0F);
    for (const float at : {-1.4F, -0.7F, 0.0F, 0.9F, 1.4F}) {
        EXPECT_LT(grid->look_up({at, -1.5F, at}, kUp).x, 3e-2F) << at;
        EXPECT_LT(grid->look_up({-1.5F, at, at}, {1.0F, 0.0F, 0.0F}).x, 3e-2F) << at;
    }
    // And the solid takes none from its outer faces.
    EXPECT_NEAR(grid->look_up({0.3F, 3.0F, -0.4F}, kUp).x, 10.0F, 0.5F);
}

TEST(Probes, AreTheSameBytesTwiceAndWithOneThreadOrMany) {
    Scene scene = tests::scene_of_all_kinds();
    Lighting light = even_light({0.7F, 0.8F, 0.9F});
    light.lights.push_back({glm::normalize(glm::vec3(1.0F, 2.0F, 0.5F)), glm::vec3(3.0F)});
    light.point_lights.push_back({{0.0F, 2.0F, -3.0F}, glm::vec3(2.0F)});
    const auto bytes = [&](int threads) {
        return texels_of(*baked(scene, light, {.most_probes = 150, .threads = threads}));
    };
    const std::vector<std::uint64_t> one = bytes(1);
    EXPECT_EQ(one, bytes(1));
    EXPECT_EQ(one, bytes(3));
    EXPECT_EQ(one.size() * sizeof(std::uint64_t), bytes_on_gpu(probes_over(bounds_of(scene), 150)));
}

TEST(Probes, AreNoPartOfAPlanThatDoesNotAskForThem) {
    Lighting light = even_light();
    light.irradiance_probes = false;
    const Scene scene = tests::facing_wall(5.0F);
    const FramePlan without = plan_frame(needs_of(scene, light), {}, 64, 64);
    EXPECT_FALSE(without.needs.irradiance_grid);
    EXPECT_EQ(without.find(Target::kDepth), nullptr);
    EXPECT_TRUE(std::any_of(without.left_out.begin(), without.left_out.end(),
                            [](const LeftOut& one) { return one.what == "irradiance probes"; }));
    light.irradiance_probes = true;
    const FramePlan with = plan_frame(needs_of(scene, light), {}, 64, 64);
    EXPECT_TRUE(with.needs.irradiance_grid);
    EXPECT_NE(with.find(Target::kDepth), nullptr);  // where a surface stands
    light.environment = nullptr;
    EXPECT_FALSE(needs_of(scene, light).irradiance_grid);
}

TEST(Probes, OfASceneWithoutSurfaceOrALightWithoutEnvironmentAreRefused) {
    EXPECT_THROW((void)baked(tests::empty_scene(), even_light()), base::Error);
    EXPECT_THROW((void)baked(tests::facing_wall(1.0F), {}), base::Error);
}

}  // namespace
}  // namespace obscura::renderer
