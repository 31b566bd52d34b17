// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What the built-in scenes' meshes must be for a picture of them to be believed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/scenes/builtin_scene.h"
#include "tests/stimuli/scenes/mesh_soundness.h"
#include "tests/stimuli/scenes/seen_soundness.h"

namespace obscura::stimuli {
namespace {

/// Above the horizon there is sky; the relic stands in an empty room, and the study's window, to
/// its left, looks out on nothing.
bool may_leave(const std::string& scene, const glm::vec3& way) {
    if (scene == "relic") return true;
    if (scene == "room" && way.x < -0.5F) return true;
    return way.y > -0.02F;
}

class BuiltinSceneMeshes : public testing::TestWithParam<BuiltinScene> {};

TEST_P(BuiltinSceneMeshes, AreSoundAsSeen) {
    const renderer::Scene scene = GetParam().build();
    const std::string& id = GetParam().id;
    for (const renderer::Mesh& mesh : scene.meshes) {
        const std::vector<std::size_t> turned = turned_triangles(mesh);
        if (turned.empty()) continue;
        const glm::vec3 place = mesh.vertices[mesh.indices[3 * turned.front()]].position_m;
        ADD_FAILURE() << mesh.name << ": normals of " << turned.size() << " of "
                      << mesh.indices.size() / 3
                      << " triangles are not on the outer side, the first at " << place.x << ' '
                      << place.y << ' ' << place.z;
    }
    std::vector<std::string> faults = faults_as_seen(
        scene, [&](const renderer::Camera&, const glm::vec3& way) { return may_leave(id, way); });
    for (const std::string& floating : floating_pieces(scene)) faults.push_back(floating);
    EXPECT_THAT(faults, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinSceneMeshes, testing::ValuesIn(builtin_scenes()),
                         [](const auto& scene) { return scene.param.id; });

}  // namespace
}  // namespace obscura::stimuli
