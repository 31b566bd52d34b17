// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "stimuli/scenes/list.h"
#include "tests/stimuli/scenes/mesh_soundness.h"

namespace obscura::stimuli {
namespace {

void expect_same(const renderer::Scene& a, const renderer::Scene& b) {
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        EXPECT_TRUE(same_mesh(a.meshes[i], b.meshes[i])) << a.meshes[i].name;
    }
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t i = 0; i < a.textures.size(); ++i) {
        EXPECT_EQ(a.textures[i].rgba, b.textures[i].rgba) << a.textures[i].name;
    }
}

/// Everything that must hold for any scene, in one test because a build takes a second.
void expect_sound_scene(const BuiltinScene& entry, const renderer::Scene& scene) {
    for (const renderer::Mesh& mesh : scene.meshes) {
        expect_sound(mesh);
        EXPECT_LT(mesh.material, scene.materials.size()) << mesh.name;
    }
    for (const renderer::Material& material : scene.materials) {
        EXPECT_LT(material.albedo_texture, static_cast<int>(scene.textures.size()));
        EXPECT_LT(material.normal_texture, static_cast<int>(scene.textures.size()));
    }
    ASSERT_EQ(scene.cameras.size(), entry.cameras.size());
    for (const std::string& name : entry.cameras) {
        const renderer::Camera* camera = scene.find_camera(name);
        ASSERT_NE(camera, nullptr) << name;
        for (const renderer::Mesh& mesh : scene.meshes) {
            EXPECT_EQ(crossings_above(mesh, camera->position_m) % 2, 0)
                << "camera " << name << " is inside " << mesh.name;
            for (const renderer::Vertex& vertex : mesh.vertices) {
                ASSERT_GT(glm::distance(vertex.position_m, camera->position_m),
                          2.0F * camera->near_m)
                    << name << " touches " << mesh.name;
            }
        }
    }
}

TEST(Relic, IsSoundClosedDetailedAndTheSameInEveryBuild) {
    const BuiltinScene entry = make_relic();
    const renderer::Scene scene = entry.build();
    expect_sound_scene(entry, scene);
    EXPECT_GE(scene.triangle_count(), 200'000U);
    EXPECT_LE(scene.triangle_count(), 900'000U);
    for (const renderer::Mesh& mesh : scene.meshes) {
        for (const auto& [a, b] : open_edges(mesh)) {
            // Open only where it stands on the ground.
            ASSERT_LT(a.y, 0.02F) << mesh.name;
            ASSERT_LT(b.y, 0.02F) << mesh.name;
        }
    }
    expect_same(scene, entry.build());
}

TEST(Relic, HasConstantLightBeforeGreyAndNothingElse) {
    const BuiltinScene entry = make_relic();
    EXPECT_EQ(entry.levels, std::vector{Validity::kLow});
    const renderer::Lighting light = entry.lighting(Validity::kLow);
    EXPECT_EQ(light.ambient, glm::vec3(1.0F));
    // Neither as bright as an open surface, whose edges would be lost, nor black.
    EXPECT_GT(light.background.x, 0.1F);
    EXPECT_LT(light.background.x, 0.3F);
    EXPECT_EQ(light.environment, nullptr);
    EXPECT_TRUE(light.lights.empty());
    EXPECT_FALSE(light.tone_mapping.has_value());
}

TEST(Figures, AreSoundClosedDetailedAndTheSameInEveryBuild) {
    const BuiltinScene entry = make_figures();
    const renderer::Scene scene = entry.build();
    expect_sound_scene(entry, scene);
    EXPECT_GE(scene.triangle_count(), 150'000U);
    EXPECT_LE(scene.triangle_count(), 900'000U);
    std::set<std::string> people;
    for (const renderer::Mesh& mesh : scene.meshes) {
        if (mesh.name == "ground" || mesh.name == "wall") continue;
        if (mesh.name.starts_with("house ")) continue;
        people.insert(mesh.name.substr(0, mesh.name.find(' ')));
        const bool cards = scene.materials[mesh.material].coverage == renderer::Coverage::kCutOut;
        EXPECT_TRUE(cards || open_edges(mesh).empty()) << mesh.name;
        float lowest = 1.0F;
        for (const renderer::Vertex& vertex : mesh.vertices)
            lowest = std::min(lowest, vertex.position_m.y);
        EXPECT_GT(lowest, -0.02F) << mesh.name << " sinks into the ground";
    }
    EXPECT_EQ(people, (std::set<std::string>{"man", "woman"}));
    expect_same(scene, entry.build());
}

TEST(Figures, MatchTheirLevels) {
    const BuiltinScene entry = make_figures();
    const renderer::Lighting moderate = entry.lighting(Validity::kModerate);
    EXPECT_NE(moderate.environment, nullptr);
    EXPECT_TRUE(moderate.lights.empty());
    const renderer::Lighting high = entry.lighting(Validity::kHigh);
    EXPECT_NE(high.environment, nullptr);
    ASSERT_EQ(high.lights.size(), 1U);
    EXPECT_NEAR(glm::length(high.lights[0].towards_light), 1.0F, 1e-5F);
    EXPECT_TRUE(high.normal_mapping);
    EXPECT_TRUE(high.tone_mapping.has_value());
}

}  // namespace
}  // namespace obscura::stimuli
