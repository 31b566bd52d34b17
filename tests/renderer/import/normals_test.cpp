// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "renderer/import/import.h"
#include "renderer/reference/backs.h"
#include "tests/renderer/import/obj_maker.h"

namespace obscura::renderer {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

TEST(ImportedNormals, ATriangleWithOneTurnedNormalIsCounted) {
    for (int turned = 0; turned <= 3; ++turned) {
        tests::GlbMaker glb = tests::triangle_glb();
        const float back[3] = {0.0F, 0.0F, -1.0F};
        for (int i = 0; i < turned; ++i) {
            std::memcpy(glb.binary.data() + 36 + 12 * i, back, sizeof back);
        }
        const auto said =
            Contains(HasSubstr("points to their back are lit as their normals say: 1 of 1"));
        if (turned == 0) {
            EXPECT_THAT(glb.import().notes, Each(Not(HasSubstr("points to their back"))));
        } else {
            EXPECT_THAT(glb.import().notes, said) << turned;
        }
    }
}

TEST(ImportedNormals, TheShareOfBacksIsThatOfTheRaysThatMeetThem) {
    // Two squares beside each other, of the same size, of which one is turned away.
    const tests::ObjMaker files;
    const ImportedScene imported = files.import(
        "v -1 0 0\nv 0 0 0\nv 0 1 0\nv -1 1 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 4\nf 2 3 6 5\n");
    Camera camera;
    camera.position_m = {0.0F, 0.5F, 5.0F};
    camera.target_m = {0.0F, 0.5F, 0.0F};
    camera.vertical_fov_rad = 0.3F;
    Camera behind = camera;
    behind.position_m.z = -5.0F;
    Camera away = camera;
    away.target_m.z = 10.0F;
    Scene scene = imported.scene;
    const auto shares = shares_of_backs(scene, {camera, behind, away}, Backs::kAll);
    EXPECT_NEAR(shares[0], 0.5, 0.05);
    EXPECT_NEAR(shares[1], 0.5, 0.05);
    EXPECT_EQ(shares[2], 0.0);
    EXPECT_EQ(shares_of_backs(scene, {camera}, Backs::kOfSingleSided)[0], 0.0);
    for (Material& material : scene.materials) material.double_sided = false;
    EXPECT_NEAR(shares_of_backs(scene, {camera}, Backs::kOfSingleSided)[0], 0.5, 0.05);
    for (Material& material : scene.materials) material.coverage = Coverage::kBlended;
    EXPECT_EQ(shares_of_backs(scene, {camera}, Backs::kAll)[0], 0.0);
}

}  // namespace
}  // namespace obscura::renderer
