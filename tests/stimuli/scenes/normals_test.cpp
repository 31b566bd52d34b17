// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "stimuli/scenes/builtin_scene.h"
#include "tests/stimuli/scenes/mesh_soundness.h"

namespace obscura::stimuli {
namespace {

class BuiltinSceneNormals : public testing::TestWithParam<BuiltinScene> {};

TEST_P(BuiltinSceneNormals, AreOnTheOuterSideOfEveryFace) {
    for (const renderer::Mesh& mesh : GetParam().build().meshes) {
        const std::vector<std::size_t> turned = turned_triangles(mesh);
        if (turned.empty()) continue;
        const glm::vec3 place = mesh.vertices[mesh.indices[3 * turned.front()]].position_m;
        ADD_FAILURE() << mesh.name << ": " << turned.size() << " of " << mesh.indices.size() / 3
                      << " triangles, the first at " << place.x << ' ' << place.y << ' ' << place.z;
    }
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinSceneNormals, testing::ValuesIn(builtin_scenes()),
                         [](const auto& scene) { return scene.param.id; });

}  // namespace
}  // namespace obscura::stimuli
